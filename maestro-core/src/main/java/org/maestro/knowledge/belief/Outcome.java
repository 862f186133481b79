package org.maestro.knowledge.belief;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.sl.Term;

/**
 * The result of a write: its facts for listeners, the beliefs for the history, and what enters and
 * leaves the dataset.
 *
 * @param facts what is, then what is not, then {@code (unknown ...)} for what was lost
 * @param expected those of them that are only expected
 * @param news every new belief, losers included
 * @param gone beliefs that are not current any more
 */
public record Outcome(List<String> facts, List<String> expected, List<News> news, List<News> gone) {

  /**
   * @param has whether the variable has the value, or is known not to have it
   * @param current false for a statement that was not believed
   */
  public record News(StateVariable variable, Held held, boolean has, boolean current) {
    public String fact() {
      return Wording.value(variable, held, has);
    }
  }

  public Outcome {
    facts = List.copyOf(facts);
    expected = List.copyOf(expected);
    news = List.copyOf(news);
    gone = List.copyOf(gone);
  }

  public static Outcome of(Draft draft, Instant now) {
    Comparison comparison = new Comparison(draft, now);
    draft.touched().forEach(comparison::compare);
    draft
        .losers()
        .forEach(
            loser ->
                comparison.news.add(
                    new News(loser.variable(), loser.claim().held(), loser.claim().has(), false)));
    List<String> facts = new ArrayList<>(comparison.facts);
    facts.addAll(comparison.exclusions);
    facts.addAll(comparison.losses);
    return new Outcome(facts, comparison.expected, comparison.news, comparison.gone);
  }

  /** Cell by cell, before and after. */
  private static final class Comparison {
    private final List<String> facts = new ArrayList<>();
    private final List<String> exclusions = new ArrayList<>();
    private final List<String> losses = new ArrayList<>();
    private final List<String> expected = new ArrayList<>();
    private final List<News> news = new ArrayList<>();
    private final List<News> gone = new ArrayList<>();
    private final Draft draft;
    private final Instant now;

    Comparison(Draft draft, Instant now) {
      this.draft = draft;
      this.now = now;
    }

    void compare(StateVariable variable) {
      Cell before = draft.base().cell(variable).orElse(Cell.LOST);
      Cell after = draft.cell(variable).orElse(Cell.LOST);
      boolean known = after.value().isPresent();
      after.settled().losers().stream()
          .filter(claim -> !before.standing().contains(claim))
          .forEach(claim -> news.add(new News(variable, claim.held(), claim.has(), false)));
      if (!isOneNote(before.value(), after.value())) {
        before.value().ifPresent(held -> left(variable, held, true));
        after.value().ifPresent(held -> came(variable, held, true, before.value()));
        before
            .value()
            .filter(held -> !known && !after.excluded().containsKey(held.value()))
            .ifPresent(held -> lost(variable, held));
      }
      for (Term value : before.excluded().keySet()) {
        Held held = before.excluded().get(value);
        if (!isOneNote(Optional.of(held), Optional.ofNullable(after.excluded().get(value)))) {
          left(variable, held, false);
          if (!known && !after.excluded().containsKey(value)) {
            lost(variable, held);
          }
        }
      }
      for (Held held : after.excluded().values()) {
        Optional<Held> same = Optional.ofNullable(before.excluded().get(held.value()));
        if (!isOneNote(same, Optional.of(held))) {
          came(variable, held, false, same);
        }
      }
    }

    private static boolean isOneNote(Optional<Held> before, Optional<Held> after) {
      return before.map(Held::serial).equals(after.map(Held::serial));
    }

    private void came(StateVariable variable, Held held, boolean has, Optional<Held> before) {
      News came = new News(variable, held, has, true);
      boolean says = has && isSo(held);
      if (says || !held.fromPosition() || before.map(Comparison::isSo).orElse(true)) {
        news.add(came);
      }
      boolean same =
          before
              .filter(old -> old.value().equals(held.value()))
              .filter(old -> old.source().kind() == held.source().kind())
              .filter(old -> old.isFresh(now))
              .isPresent();
      if (!same && !rulesOutWhatNobodyBelieved(held, has, before)) {
        (says ? facts : exclusions).add(came.fact());
        if (held.isExpected()) {
          expected.add(came.fact());
        }
      }
    }

    private static boolean isSo(Held held) {
      return !held.value().equals(new Term.Truth(false));
    }

    /** Effects rule out a lot in one sweep; only what was believed before is worth telling. */
    private boolean rulesOutWhatNobodyBelieved(Held held, boolean has, Optional<Held> before) {
      return has
          && held.source().kind() == Source.Kind.EXPECTED
          && held.value().equals(new Term.Truth(false))
          && before.filter(old -> old.value().equals(new Term.Truth(true))).isEmpty();
    }

    private void left(StateVariable variable, Held held, boolean has) {
      gone.add(new News(variable, held, has, true));
    }

    private void lost(StateVariable variable, Held held) {
      losses.add(Wording.unknown(variable, held));
    }
  }
}
