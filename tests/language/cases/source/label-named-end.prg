3.1
label named end
END:
SLEEP 20
