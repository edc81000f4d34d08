# Hewlett-Packard 7475A, six pens, A/A4 and B/A3 paper.
# Lengths in millimetres unless a line says plotter units. A # with a blank after it begins a comment.
name: HP 7475A
unit: 0.02488          # one plotter unit
buffer: 1024           # bytes of input
range: 32767           # largest coordinate, plotter units
speed: 0.38 38.1       # pen down, cm/s: slowest and fastest

# paper: name, width and height; where the plotter's origin lies, from the left and from the
# bottom edge; the hard-clip limits in plotter units (lower left 0 0 to X Y). X is the long side.
# Set the plotter's switches to the paper's size. B's origin is A3's: no published figure.
paper: A4  297    210    10  4    11040  7721
paper: A3  420    297    15  10   16158 11040
paper: A   279.4  215.9  10  4.9  10365  7962
paper: B   431.8  279.4  15  10   16640 10365

# pen: stall of the carousel, width of its line, colour. Lines and hatching both black.
pen: 1  0.3  #000000
pen: 2  0.3  #000000
pen: 3  0.3  #c00000
pen: 4  0.3  #007a2e
pen: 5  0.3  #1030b0
pen: 6  0.3  #7a3c00
