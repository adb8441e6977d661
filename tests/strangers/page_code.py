"""page_code.py PAGE LANGUAGE: prints the code blocks of a page in one language, in their order, as one program."""
import re
import sys

page, language = sys.argv[1:]
blocks = re.findall(r"^```%s\n(.*?)^```$" % re.escape(language), open(page, encoding="utf-8").read(), re.M | re.S)
if not blocks:
    sys.exit(f"{page}: found no block of {language}")
print("\n".join(blocks))
