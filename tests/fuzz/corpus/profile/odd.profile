unit: 1e-3
paper: A4 1 1 0 0 5.5 5
paper: A4 2 2 0 0 9 9
pen: 3 1 #zz
