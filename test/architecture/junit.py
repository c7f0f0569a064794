"""Runs a test without ROS and writes its results in JUnit's form, with what was skipped, which rosunit does not tell."""
import pathlib
import time
import unittest
import xml.etree.ElementTree as ET


class Results(unittest.TextTestResult):
    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.suite = ET.Element('testsuite')

    def startTest(self, test):
        super().startTest(test)
        self.began = time.monotonic()
        self.case = ET.SubElement(self.suite, 'testcase', name=test.id().rpartition('.')[2], classname=type(test).__name__)

    def stopTest(self, test):
        super().stopTest(test)
        self.case.set('time', '%.3f' % (time.monotonic() - self.began))

    def addFailure(self, test, error):
        super().addFailure(test, error)
        ET.SubElement(self.case, 'failure', message=str(error[1]))

    def addError(self, test, error):
        super().addError(test, error)
        if not isinstance(test, unittest.TestCase):  # setUpClass
            self.case = ET.SubElement(self.suite, 'testcase', name=str(test), classname='')
        ET.SubElement(self.case, 'error', message=str(error[1]))

    def addSkip(self, test, reason):
        super().addSkip(test, reason)
        ET.SubElement(self.case, 'skipped', message=reason)


def run(test, path=None):
    """Of a class of tests. Returns the exit code."""
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(test)
    result = unittest.TextTestRunner(resultclass=Results, verbosity=2).run(suite)
    if path:
        counts = {'tests': result.testsRun, 'failures': len(result.failures), 'errors': len(result.errors)}
        result.suite.attrib.update({name: str(count) for name, count in counts.items()}, name=test.__name__)
        pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
        ET.ElementTree(result.suite).write(path, encoding='utf-8', xml_declaration=True)
    return 0 if result.wasSuccessful() else 1
