package org.maestro.slowest;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;

/** What the modules before have left of their tests. */
final class SurefireReports {
  private static final Path REPORTS = Path.of("target/surefire-reports");

  /** Modules stand in the root, or in one of its folders. */
  private static final int DEPTH = 4;

  private SurefireReports() {}

  /**
   * The tests of all modules whose reports are complete.
   *
   * @param root the directory with the modules
   * @param began reports from before are of another build
   */
  static List<TimedTest> since(Path root, Instant began) {
    List<TimedTest> tests = new ArrayList<>();
    try (Stream<Path> found = Files.find(root, DEPTH, (path, kind) -> path.endsWith(REPORTS))) {
      for (Path reports : found.filter(path -> !isHere(path)).sorted().toList()) {
        try (Stream<Path> files = Files.list(reports)) {
          for (Path file : files.filter(path -> path.toString().endsWith(".xml")).toList()) {
            if (!Files.getLastModifiedTime(file).toInstant().isBefore(began)) {
              tests.addAll(read(file));
            }
          }
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException("The reports of the tests before cannot be read.", e);
    }
    return tests;
  }

  /** This module's reports are still being written. */
  private static boolean isHere(Path reports) {
    return reports.toAbsolutePath().normalize().equals(REPORTS.toAbsolutePath());
  }

  private static List<TimedTest> read(Path file) throws IOException {
    try {
      NodeList cases =
          DocumentBuilderFactory.newInstance()
              .newDocumentBuilder()
              .parse(file.toFile())
              .getElementsByTagName("testcase");
      List<TimedTest> tests = new ArrayList<>();
      for (int i = 0; i < cases.getLength(); i++) {
        Element test = (Element) cases.item(i);
        String type = SlowestTests.simple(test.getAttribute("classname"));
        double seconds = Double.parseDouble(test.getAttribute("time").replace(",", ""));
        tests.add(
            new TimedTest(
                type + "#" + test.getAttribute("name"),
                Duration.ofMillis(Math.round(seconds * 1000))));
      }
      return tests;
    } catch (ParserConfigurationException | SAXException e) {
      throw new IOException("The report " + file + " is none.", e);
    }
  }
}
