name: A B
unit: 0.025
range: 9
paper: A4 297 210 10 4 11040 7721
pen: 1 0.3 #000000
pen: 2 0.3 #c00000
speed: 1 2
