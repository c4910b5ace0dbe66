3.1
A title
DEF_VAR 歩幅
歩幅 = 3
END
