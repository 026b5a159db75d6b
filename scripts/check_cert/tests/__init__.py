"""Tests of the checker: python3 -m unittest discover -s scripts -t scripts"""
