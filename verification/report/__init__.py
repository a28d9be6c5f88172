"""What a person reads: the terminal table, the page in HTML, the page in Markdown."""
