3.1
Zero decimals truncate
DEF_VAR A
A = 2.9
MESSAGE %A.0%
A = -0.9
MESSAGE <%A.0%>
END
