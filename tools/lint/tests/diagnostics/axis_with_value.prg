3.1
One axis as in G-code
PTP F1 -391 201 Z150
END
