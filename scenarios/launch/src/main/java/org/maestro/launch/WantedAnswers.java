package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;

/** What can be chosen, or set, to answer a question of a script, as lines of a terminal. */
final class WantedAnswers {
  private WantedAnswers() {}

  /**
   * A line for each choice, with the number by which it is chosen, or one for the range of a
   * slider; none where words are wanted.
   *
   * @param entry of the chat
   */
  static List<String> of(JsonNode entry) {
    List<String> lines = new ArrayList<>();
    for (JsonNode choice : entry.path("choice")) {
      lines.add("  %d  %s".formatted(lines.size() + 1, choice.asText()));
    }
    JsonNode slider = entry.path("slider");
    if (slider.isObject()) {
      lines.add(
          "  from %s to %s, by steps of %s"
              .formatted(
                  end(slider, "lowest"),
                  end(slider, "highest"),
                  JsonRows.plain(slider.path("step"))));
    }
    return lines;
  }

  private static String end(JsonNode slider, String name) {
    String label = slider.path(name + "_label").asText();
    return JsonRows.plain(slider.path(name)) + (label.isEmpty() ? "" : " (" + label + ")");
  }
}
