package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * A kind of mistake, as the files under {@code mistakes} list them: changes of a text without
 * fault, and what is to be said of it then.
 *
 * @param edits in this order
 */
record Mistake(String name, List<Edit> edits, List<Finding> findings) {

  /**
   * A change.
   *
   * @param replaced empty: what is new is put behind the end
   */
  private record Edit(String replaced, String by) {

    String of(String text) {
      if (replaced.isEmpty()) {
        return text + by + "\n";
      }
      assertThat(text).as("what is replaced").contains(replaced);
      int place = text.indexOf(replaced);
      return text.substring(0, place) + by + text.substring(place + replaced.length());
    }
  }

  /**
   * What is to be said.
   *
   * @param sentence the problem and its cure
   * @param line the whole line that is named, without the blanks around it
   */
  record Finding(boolean isFault, String sentence, String line) {}

  /** All kinds of a file. */
  static Stream<Mistake> all(String resource) {
    String text = Shipped.text(resource).orElseThrow().replaceAll("(?m)^#.*\\n", "");
    return Arrays.stream(text.split("(?m)^== ")).filter(part -> !part.isBlank()).map(Mistake::read);
  }

  private static Mistake read(String part) {
    List<String> lines = part.lines().filter(line -> !line.isBlank()).toList();
    List<Edit> edits = new ArrayList<>();
    List<Finding> findings = new ArrayList<>();
    for (int i = 1; i < lines.size(); i++) {
      String[] said = lines.get(i).split(" ", 2);
      switch (said[0]) {
        case "replace" -> edits.add(new Edit(value(said), value(lines.get(++i).split(" ", 2))));
        case "add" -> edits.add(new Edit("", value(said)));
        case "fault", "warning" ->
            findings.add(
                new Finding(said[0].equals("fault"), said[1], value(lines.get(++i).split(" ", 2))));
        default -> throw new IllegalArgumentException(lines.get(i));
      }
    }
    return new Mistake(lines.get(0), edits, findings);
  }

  private static String value(String[] said) {
    return said.length < 2 ? "" : said[1].replace("\\n", "\n");
  }

  /** The text with the mistake. */
  String in(String right) {
    String wrong = right;
    for (Edit edit : edits) {
      wrong = edit.of(wrong);
    }
    return wrong;
  }

  @Override
  public String toString() {
    return name;
  }
}
