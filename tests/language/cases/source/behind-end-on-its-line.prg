3.1
behind end on its line
SLEEP 20 ; END 5 ; FOO = = 全
