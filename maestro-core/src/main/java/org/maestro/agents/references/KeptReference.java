package org.maestro.agents.references;

import jade.core.AID;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * A reference that is asked for again whenever there is none, and now and then to a better one.
 * Agent thread only.
 */
public final class KeptReference implements Holder {
  private static final Duration TRY_AGAIN = Duration.ofSeconds(2);
  private static final Duration FOR_A_BETTER_ONE = Duration.ofSeconds(10);

  private final References references;
  private final List<Wanted> wanted;
  private final Consumer<KeptReference> changed;
  private Optional<Reference> now = Optional.empty();
  private String reason = "it has not been asked for yet";
  private int asked;

  KeptReference(References references, List<Wanted> wanted, Consumer<KeptReference> changed) {
    this.references = references;
    this.wanted = List.copyOf(wanted);
    this.changed = changed;
  }

  /** The one referred to; empty while there is none. */
  public Optional<AID> agent() {
    return now.map(Reference::agent);
  }

  /** Why there is none, or was none last. */
  public String reason() {
    return reason;
  }

  void ask() {
    references.ask(wanted.get(asked), this);
  }

  private void askForTheFirst() {
    if (now.isPresent()) {
      asked = 0;
      ask();
    }
  }

  @Override
  public void referred(Reference reference) {
    now.ifPresent(references::drop);
    now = Optional.of(reference);
    if (asked > 0) {
      references.later(FOR_A_BETTER_ONE, this::askForTheFirst);
    }
    changed.accept(this);
  }

  @Override
  public void refused(String why) {
    if (now.isPresent()) {
      references.later(FOR_A_BETTER_ONE, this::askForTheFirst);
      return;
    }
    reason = why;
    asked = (asked + 1) % wanted.size();
    if (asked == 0) {
      references.later(TRY_AGAIN, this::ask);
    } else {
      ask();
    }
  }

  @Override
  public void lost(Reference reference, String why) {
    now = Optional.empty();
    reason = why;
    asked = 0;
    changed.accept(this);
    ask();
  }
}
