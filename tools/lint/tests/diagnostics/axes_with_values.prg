3.1
Axes as in G-code
PTP F1 X-391 Y201 Z-150
END
