package org.maestro.console.chat;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import org.maestro.language.wording.GoalWords;
import org.maestro.sl.Formula;

/**
 * Which goals are meant by who calls something off.
 *
 * @param meant of these it is certain
 * @param possible else one of these is meant
 */
record CallingOff(List<KnownGoal> meant, List<KnownGoal> possible) {
  CallingOff {
    meant = List.copyOf(meant);
    possible = List.copyOf(possible);
  }

  /**
   * What she has asked for last, as long as it is not over; else what is under way.
   *
   * @param last ids of what she has asked for last
   */
  static CallingOff last(List<KnownGoal> goals, String person, List<String> last) {
    List<KnownGoal> open = goals.stream().filter(goal -> !goal.isOver()).toList();
    List<KnownGoal> latest = open.stream().filter(goal -> last.contains(goal.id())).toList();
    List<KnownGoal> own = open.stream().filter(goal -> goal.isBy(person)).toList();
    return latest.isEmpty()
        ? new CallingOff(List.of(), own.isEmpty() ? open : own)
        : new CallingOff(latest, List.of());
  }

  /** What has to do with what is spoken of: what she has asked for before what others have. */
  static CallingOff of(List<KnownGoal> goals, String person, Formula spoken) {
    Predicate<KnownGoal> fits =
        goal -> goal.formula().filter(formula -> Concern.isOf(formula, spoken)).isPresent();
    List<KnownGoal> open = goals.stream().filter(goal -> !goal.isOver()).filter(fits).toList();
    List<KnownGoal> own = open.stream().filter(goal -> goal.isBy(person)).toList();
    List<KnownGoal> possible = own.isEmpty() ? open : own;
    boolean isOneTurn =
        possible.stream().mapToLong(KnownGoal::turn).distinct().count() == 1
            && (possible.size() == 1 || possible.get(0).turn() > 0);
    return isOneTurn ? new CallingOff(possible, List.of()) : new CallingOff(List.of(), possible);
  }

  /** Those of several that an answer names: by words of what is done for it. */
  static List<KnownGoal> named(List<KnownGoal> several, String answer, GoalWords words) {
    String said = plain(answer);
    List<String> choices = words.choices(several.stream().map(KnownGoal::wish).toList());
    List<KnownGoal> found = new ArrayList<>();
    for (int i = 0; i < several.size(); i++) {
      if (!said.isEmpty() && plain(choices.get(i)).contains(said)) {
        found.add(several.get(i));
      }
    }
    return found.size() == 1 ? List.copyOf(found) : List.of();
  }

  private static String plain(String text) {
    return text.toLowerCase(Locale.ROOT).replaceAll("[.!?,]", "").strip();
  }
}
