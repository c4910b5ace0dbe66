3.1
Which feet carry something
DEF_VAR FL, FR, RL, RR
AD_IN PAW1 FL
AD_IN PAW2 FR
AD_IN PAW3 RL
AD_IN PAW4 RR
IF FL > 1 THEN
  MESSAGE the front left foot carries
ENDIF
MESSAGE %FL.1% %FR.1% %RL.1% %RR.1%
END
