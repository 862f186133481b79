package org.maestro.language;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.maestro.language.meaning.Meaning;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;

/**
 * What may be begun of an utterance before its end, and what of it is called off by words that
 * follow (A12). Not safe for threads.
 */
final class Beginning {
  /** More unusual readings than these wait for the end: what follows may show another. */
  private static final int USUAL = 1;

  private final List<Understanding.Begun> began = new ArrayList<>();

  /**
   * After the word it is certain that this is meant, if nothing else follows.
   *
   * @param open whether it is likely that something does, as a unit after a number: nothing is
   *     begun then
   */
  void understood(String word, Meaning meaning, boolean open) {
    Optional<Content> message = meaning.message();
    boolean mayBegin =
        !open
            && meaning.early()
            && meaning.penalty() <= USUAL
            && message.flatMap(Meaning::goal).isPresent();
    if (message.isEmpty()) {
      return;
    }
    Optional<Understanding.Begun> last = underWay();
    boolean isSame = last.filter(begun -> begun.message().equals(message.get())).isPresent();
    if (isSame) {
      return;
    }
    if (last.isPresent() && !isPartOf(last.get().message(), message.get())) {
      callOff(word);
    }
    if (mayBegin) {
      began.add(new Understanding.Begun(word, message.get(), Optional.empty()));
    }
  }

  private Optional<Understanding.Begun> underWay() {
    return began.isEmpty()
        ? Optional.empty()
        : Optional.of(began.get(began.size() - 1)).filter(last -> last.calledOff().isEmpty());
  }

  /** Whether who does the whole does the part, too. */
  private static boolean isPartOf(Content part, Content whole) {
    return whole.operator().equals(part.operator())
        && Meaning.goal(whole).isPresent()
        && conjuncts(whole).containsAll(conjuncts(part));
  }

  private static Set<Formula> conjuncts(Content content) {
    return Meaning.goal(content)
        .map(
            goal ->
                goal instanceof Formula.And and
                    ? new HashSet<>(and.operands())
                    : new HashSet<>(Set.of(goal)))
        .orElseGet(HashSet::new);
  }

  /** The word takes back what was said before it. */
  void callOff(String word) {
    for (int i = 0; i < began.size(); i++) {
      if (began.get(i).calledOff().isEmpty()) {
        began.set(i, began.get(i).calledOffAfter(word));
      }
    }
  }

  /** Nothing more is said, and this was meant. */
  void end(Optional<Content> meant, String lastWord) {
    if (underWay()
        .filter(last -> meant.filter(whole -> isPartOf(last.message(), whole)).isEmpty())
        .isPresent()) {
      callOff(lastWord);
    }
  }

  List<Understanding.Begun> began() {
    return List.copyOf(began);
  }
}
