"""Tests of the checker: cd scripts && python3 -m unittest discover -t . -s check_cert/tests"""
