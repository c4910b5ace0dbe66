3.1
The potentiometers of a hip and of a knee
DEF_VAR HIP, KNEE
AD_IN J11 HIP
AD_IN J13 KNEE
MESSAGE %HIP.2% V %KNEE.2% V
END
