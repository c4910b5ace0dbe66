3.1
What follows END is not looked at
MESSAGE done
END
so here is room for notes
