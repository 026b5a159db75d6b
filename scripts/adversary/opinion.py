"""What the second checker says of a certificate. It shares nothing with the kernel, nor with this folder."""

from check_cert.main import check_text


def second_opinion(source, certificate, shown):
    """What the second checker refuses, and how many links it accepts."""
    said = []
    try:
        check_text(source.encode("utf-8"), certificate, said.append)
    except Exception as why:
        said.append(f"NO   document: {why!r}")
    if [c["verdict"] for c in certificate["claims"]] != shown:
        said.append("NO   the certificate has other verdicts than the report")
    return [line for line in said if line.startswith("NO")], sum(" link " in line and line.startswith("yes") for line in said)
