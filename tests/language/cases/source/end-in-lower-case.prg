3.1
end in lower case
end
foo
