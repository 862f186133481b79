package org.maestro.agents.knowledge;

import java.util.Optional;
import java.util.function.Supplier;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.runtime.Caller;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.PrivateWords;
import org.maestro.ontology.home.ReadingRights;

/**
 * Those who read the collective knowledge, and what of it is kept from each (ADE, 4.1; A30, A57):
 * the one place where that is decided. Any thread may ask.
 */
public final class Readers {
  private final Supplier<Home> home;

  /** Whatever threads see of it is right: it is looked up anew where it is of another home. */
  private volatile Optional<Looked> latest = Optional.empty();

  /** To look through a home takes long where many ask. */
  private record Looked(Home home, PrivateWords words) {}

  /**
   * @param home as it is known at the time
   */
  public Readers(Supplier<Home> home) {
    this.home = home;
  }

  /**
   * What the caller may read. On an open site the desk asks for whoever is at the console, which is
   * on the machine itself; on a secured one for a person.
   */
  public ReadingRights of(Caller caller) {
    boolean isOperator = caller.agent().equals(AgentNames.DESK) && caller.user().isEmpty();
    return words().of(caller.names(), isOperator);
  }

  @SuppressWarnings("ReferenceEquality") // Another state of the home is another object.
  private PrivateWords words() {
    Home now = home.get();
    Optional<Looked> known = latest.filter(looked -> looked.home() == now);
    Looked looked = known.orElseGet(() -> new Looked(now, PrivateWords.of(now)));
    latest = Optional.of(looked);
    return looked.words();
  }
}
