package org.maestro.language.meaning;

import java.util.List;
import java.util.Optional;
import org.maestro.language.grammar.Form;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * What a reading means in a situation.
 *
 * @param form the reading
 * @param message empty when there is a doubt
 * @param kind what kind of utterance it is: {@code command}, {@code question}, {@code statement},
 *     {@code rule}, {@code answer}, {@code cancel}, {@code social}
 * @param broken how many references do not say what they promise
 * @param early whether it may be begun before the sentence ends
 * @param mentioned what was referred to, the latest last
 * @param classes the kinds of things that were spoken of
 * @param group several things that were referred to together
 */
public record Meaning(
    Form form,
    Optional<Content> message,
    Optional<Doubt> doubt,
    String kind,
    int broken,
    int penalty,
    boolean early,
    List<Term.Name> mentioned,
    List<String> classes,
    List<Term.Name> group) {
  public Meaning {
    mentioned = List.copyOf(mentioned);
    classes = List.copyOf(classes);
    group = List.copyOf(group);
  }

  /** The same, which it is not certain that it is meant. */
  public Meaning doubted(Doubt why) {
    return new Meaning(
        form,
        Optional.empty(),
        Optional.of(why),
        kind,
        broken,
        penalty,
        false,
        mentioned,
        classes,
        group);
  }

  /** The same, where it is the meaning of more than that. */
  Meaning of(Form whole) {
    return new Meaning(
        whole, message, doubt, kind, broken, penalty, early, mentioned, classes, group);
  }

  /** The formula of a message that states a goal. */
  public static Optional<Formula> goal(Content message) {
    return Acts.goalOf(message);
  }
}
