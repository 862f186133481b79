package org.maestro.scenario;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.references.Holder;
import org.maestro.agents.references.Reference;
import org.maestro.agents.references.Wanted;

/** A reference for which a desk has asked, and what it was told of that. */
public final class AskedReference implements Holder {
  private final List<String> reasons = new CopyOnWriteArrayList<>();
  private volatile Optional<Reference> reference = Optional.empty();

  private AskedReference() {
    // The desk's thread tells the rest.
  }

  public static AskedReference by(DeskAgent desk, Wanted wanted) {
    AskedReference asked = new AskedReference();
    desk.tell(() -> desk.references().ask(wanted, asked));
    return asked;
  }

  /** Whether it was accepted or refused. */
  public boolean isAnswered() {
    return reference.isPresent() || !reasons.isEmpty();
  }

  public Optional<Reference> reference() {
    return reference;
  }

  /** Why it was refused, or lost. */
  public List<String> reasons() {
    return reasons;
  }

  @Override
  public void referred(Reference its) {
    reference = Optional.of(its);
  }

  @Override
  public void refused(String reason) {
    reasons.add(reason);
  }

  @Override
  public void lost(Reference its, String reason) {
    reasons.add(reason);
  }
}
