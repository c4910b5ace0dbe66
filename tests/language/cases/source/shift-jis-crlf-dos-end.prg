3.1
‘è
MESSAGE@•\Ž¦”\
END