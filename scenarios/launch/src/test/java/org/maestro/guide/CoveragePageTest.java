package org.maestro.guide;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** {@code docs/coverage.md} counts its rows rightly, and names only tests that there are. */
class CoveragePageTest {
  private static final Path ROOT = Path.of("../..").toAbsolutePath().normalize();
  private static final Pattern SECTION = Pattern.compile("(?m)^## .*: (\\d+) rows$");
  private static final Pattern COUNTS =
      Pattern.compile("(?m)^(\\d+) done, (\\d+) partly, (\\d+) open\\.$");
  private static final Pattern ROW =
      Pattern.compile("(?m)^\\| [AM]\\d+ \\|[^|]*\\| (\\w+) \\|([^|]*)\\|([^|]*)\\|$");
  private static final Pattern TEST = Pattern.compile("`(\\w+)#(\\w+)`");

  private record Section(int rows, String text) {
    long in(String state) {
      return rowsThere().filter(row -> row.group(1).equals(state)).count();
    }

    Stream<MatchResult> rowsThere() {
      return ROW.matcher(text).results();
    }
  }

  @Test
  void eachTableHasTheRowsThatStandAboveIt() throws IOException {
    for (Section section : sections()) {
      assertThat(section.rowsThere()).hasSize(section.rows());
      assertThat(COUNTS.matcher(section.text()).results().map(MatchResult::group))
          .containsExactly(
              "%d done, %d partly, %d open."
                  .formatted(section.in("done"), section.in("partly"), section.in("open")));
      assertThat(section.text().stripTrailing().lines().dropWhile(line -> !line.startsWith("|")))
          .as("nothing stands within the table")
          .allMatch(line -> line.startsWith("|"));
    }
  }

  @Test
  void whatIsDoneNamesATestAndWhatIsNotSaysWhatIsMissing() throws IOException {
    for (Section section : sections()) {
      assertThat(section.rowsThere())
          .allMatch(row -> !row.group(1).equals("done") || TEST.matcher(row.group(2)).find())
          .allMatch(row -> !row.group(1).equals("partly") || !row.group(3).isBlank());
    }
  }

  @Test
  void eachTestThatIsNamedIsThere() throws IOException {
    Map<String, String> sources = sources();
    List<String> missing = new ArrayList<>();
    for (Section section : sections()) {
      TEST.matcher(section.text())
          .results()
          .filter(
              test ->
                  !Pattern.compile("\\b" + test.group(2) + "\\b")
                      .matcher(sources.getOrDefault(test.group(1), ""))
                      .find())
          .map(MatchResult::group)
          .forEach(missing::add);
    }

    assertThat(missing).isEmpty();
  }

  private static List<Section> sections() throws IOException {
    String page = Files.readString(ROOT.resolve("docs/coverage.md"));
    List<MatchResult> heads = SECTION.matcher(page).results().toList();
    assertThat(heads).hasSize(2);
    List<Section> sections = new ArrayList<>();
    for (int i = 0; i < heads.size(); i++) {
      int end = i + 1 < heads.size() ? heads.get(i + 1).start() : page.length();
      sections.add(
          new Section(
              Integer.parseInt(heads.get(i).group(1)), page.substring(heads.get(i).end(), end)));
    }
    return sections;
  }

  /** By class; of those that share a name all. */
  private static Map<String, String> sources() throws IOException {
    Map<String, String> sources = new HashMap<>();
    try (Stream<Path> files = Files.walk(ROOT)) {
      for (Path file :
          files
              .filter(file -> file.toString().contains("/src/test/java/"))
              .filter(file -> file.toString().endsWith(".java"))
              .toList()) {
        String name = String.valueOf(file.getFileName()).replace(".java", "");
        sources.merge(name, Files.readString(file), String::concat);
      }
    }
    return sources;
  }
}
