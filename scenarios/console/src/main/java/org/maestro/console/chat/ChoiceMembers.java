package org.maestro.console.chat;

import java.util.Optional;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.documents.ShownText;
import org.maestro.coordination.api.Speech;
import org.maestro.sl.AnswerFormat;

/** What can be chosen, or set, to answer a question, in JSON: null where words are wanted. */
final class ChoiceMembers {
  private ChoiceMembers() {}

  static void add(JsonMembers row, Optional<Speech.Wanted> wanted) {
    wanted
        .filter(it -> it.type().equals(Speech.Wanted.CHOICE))
        .ifPresentOrElse(
            choice -> row.words("choice", choice.choices().stream().map(ShownText::of).toList()),
            () -> row.node().putNull("choice"));
    wanted
        .flatMap(Speech.Wanted::slider)
        .ifPresentOrElse(
            slider -> add(row.in("slider"), slider), () -> row.node().putNull("slider"));
  }

  private static void add(JsonMembers members, AnswerFormat.Slider slider) {
    members
        .number("lowest", slider.lowest())
        .number("highest", slider.highest())
        .number("step", slider.step());
    members
        .node()
        .put("lowest_label", ShownText.of(slider.lowestLabel()))
        .put("highest_label", ShownText.of(slider.highestLabel()));
  }
}
