package org.maestro.agents.runtime;

import jade.lang.acl.ACLMessage;
import java.util.Optional;
import java.util.function.Supplier;
import org.maestro.agents.content.Words;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Part;
import org.maestro.ontology.home.PartList;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Lets messages through to the parts of one agent, if the home opens them to whoever sent these, as
 * its file has it at that moment (ADE, 3.1; A26, A28, A29). The platform's own agents need no
 * permission. Agent thread only.
 */
public final class PartGuard {
  private static final Logger LOG = LoggerFactory.getLogger(PartGuard.class);

  private final MaestroAgent agent;
  private final Supplier<Home> home;
  private final Spokesmen spokesmen;
  private final Once refused = new Once();
  private Optional<Read> latest = Optional.empty();

  /** To look through a home takes long where many ask. */
  private record Read(Home home, PartList list) {}

  /**
   * @param home as it is known at the time
   */
  public PartGuard(MaestroAgent agent, Supplier<Home> home, Spokesmen spokesmen) {
    this.agent = agent;
    this.home = home;
    this.spokesmen = spokesmen;
  }

  /** Whether who sent the message may use the part; who may not is told so. */
  public boolean admits(ACLMessage message, Words words, Part part) {
    Caller caller = Caller.of(message, agent.getHap()).askingFor(words.string("for"));
    Optional<String> objection = list().objection(caller.names(), agent.getLocalName(), part);
    if (objection.isEmpty() || spokesmen.isOwn(caller)) {
      return true;
    }
    agent.refuse(message, ACLMessage.REFUSE, objection.get());
    if (refused.isNew(objection.get())) {
      LOG.warn("{} refuses: {}", agent.getLocalName(), objection.get());
    }
    return false;
  }

  @SuppressWarnings("ReferenceEquality") // Another state of the home is another object.
  private PartList list() {
    Home now = home.get();
    Read read =
        latest.filter(one -> one.home() == now).orElseGet(() -> new Read(now, PartList.of(now)));
    latest = Optional.of(read);
    return read.list();
  }
}
