package org.maestro.coordination.worth;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;

/** The shape of a goal: its words, with classes for individuals, and no numbers. */
final class GoalShape {
  private static final Pattern WORD = Pattern.compile("[^\\s()]+");
  private static final Pattern NUMBER = Pattern.compile("-?\\d.*");

  private GoalShape() {}

  /** Two goals of one shape are as likely to be reached, for all that is known. */
  static String of(Formula goal, Home home) {
    StringBuilder shape = new StringBuilder();
    Matcher words = WORD.matcher(SlPrinter.print(goal));
    while (words.find()) {
      words.appendReplacement(shape, Matcher.quoteReplacement(shaped(words.group(), home)));
    }
    return words.appendTail(shape).toString();
  }

  private static String shaped(String word, Home home) {
    if (home.individuals().containsKey(word)) {
      return String.join("|", home.individuals().get(word).classes());
    }
    return NUMBER.matcher(word).matches() ? "#" : word;
  }
}
