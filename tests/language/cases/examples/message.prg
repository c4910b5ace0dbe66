3.1
Numbers in a message
DEF_VAR N, PART
N = 3.7
PART = 2 / 3
MESSAGE N is %N%, rounded %N.1%, and two thirds are %PART.3%
MESSAGE 100 % of it\twith a tab
END
