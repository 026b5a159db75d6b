"""Checks the certificates of derivation documents.

Written from docs/derivation-language.md and docs/certificates.md alone. It
shares no code with the program that writes the certificates: a verdict that
both accept has been checked twice, by readers who never met.
"""
