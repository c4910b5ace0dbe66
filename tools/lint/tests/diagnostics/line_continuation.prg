3.1
A title
PTP F1 391 _
  201 -150
END
