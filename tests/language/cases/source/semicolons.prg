3.1
semicolons
SLEEP 20 ; SLEEP 40;SLEEP 60
SLEEP 20 ;; SLEEP 40 ;
;
 ; , ;
END
