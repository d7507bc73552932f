module mdrcontact.example

go 1.19
