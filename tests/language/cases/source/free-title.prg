3.1
END ; FOO // 説明　ｱ : = = ELSE X = 1
SLEEP 20
END
