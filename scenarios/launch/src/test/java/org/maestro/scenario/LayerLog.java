package org.maestro.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.maestro.platform.jade.SentMessage;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.MessageKind;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Disturbance;
import org.maestro.rats.transport.Publication;

/**
 * The log of who talks with whom, by messages between agents and by packets of the bus, and of what
 * of that the layers do not have (Three-layered architecture, 3; M23): layers talk with the next
 * one, and within the domain and the control layer each with each. Any thread may tell it.
 */
final class LayerLog implements Disturbance {

  /** From the bottom to the top. */
  enum Layer {
    HARDWARE,
    DOMAIN,
    CONTROL;

    boolean mayTalkTo(Layer other) {
      return this == other ? this != HARDWARE : Math.abs(ordinal() - other.ordinal()) == 1;
    }
  }

  /**
   * One who talks.
   *
   * @param layer empty: nobody knows, and so it may talk to none
   */
  record Party(String name, Optional<Layer> layer) {
    static Party of(String name, Layer layer) {
      return new Party(name, Optional.of(layer));
    }

    boolean mayTalkTo(Party other) {
      return layer.isPresent()
          && other.layer.isPresent()
          && layer.get().mayTalkTo(other.layer.get());
    }
  }

  /** A message or packet from one to another. */
  record Talk(Party from, Party to, String what) {
    boolean isBetween(Layer one, Layer other) {
      return from.layer.equals(Optional.of(one)) && to.layer.equals(Optional.of(other));
    }
  }

  private final Topics topics;
  private final Set<String> members;
  private final Set<String> controllers;
  private final WireFormat wire = new WireFormat();
  private final List<Talk> talks = new ArrayList<>();
  private final List<String> faults = new ArrayList<>();

  /**
   * @param members RATS members by their ids, which are those of their clients
   * @param controllers clients of the bus by which the control layer talks to them
   */
  LayerLog(Topics topics, Set<String> members, Set<String> controllers) {
    this.topics = topics;
    this.members = Set.copyOf(members);
    this.controllers = Set.copyOf(controllers);
  }

  synchronized void add(Talk talk) {
    talks.add(talk);
    if (!talk.from.mayTalkTo(talk.to)) {
      faults.add("%s must not tell %s %s.".formatted(talk.from.name, talk.to.name, talk.what));
    }
  }

  /** Agents of JADE are the control layer; what is no agent of this platform is of no layer. */
  void sent(SentMessage message, String platform) {
    add(
        new Talk(
            agent(message.sender(), platform),
            agent(message.receiver(), platform),
            message.performative()));
  }

  private static Party agent(String name, String platform) {
    return new Party(
        name, Optional.of(Layer.CONTROL).filter(control -> name.endsWith("@" + platform)));
  }

  @Override
  public List<Copy> published(String client, Publication publication) {
    Party from = onBus(client);
    if (!topics.speakerOf(publication.topic()).equals(client)) {
      complain("%s speaks on %s, which is not its own.".formatted(client, publication.topic()));
    }
    receivers(publication)
        .filter(receiver -> !receiver.equals(client))
        .forEach(receiver -> add(new Talk(from, onBus(receiver), publication.topic())));
    return Disturbance.super.published(client, publication);
  }

  private synchronized void complain(String fault) {
    faults.add(fault);
  }

  private Party onBus(String client) {
    if (members.contains(client)) {
      return Party.of(client, Layer.DOMAIN);
    }
    return controllers.contains(client)
        ? Party.of(client, Layer.CONTROL)
        : new Party(client, Optional.empty());
  }

  /** Whom a packet is for: who is named in it, or all who may listen to what is for everybody. */
  private Stream<String> receivers(Publication publication) {
    Optional<String> named = topics.receiverOf(publication.topic());
    if (named.isPresent()) {
      return named.stream();
    }
    if (topics.kindOf(publication.topic()).equals(Optional.of(MessageKind.CALL))) {
      Call call = wire.decodeCall(publication.payload());
      return call.member().map(Stream::of).orElseGet(members::stream);
    }
    return Stream.concat(controllers.stream(), members.stream());
  }

  synchronized List<Talk> talks() {
    return List.copyOf(talks);
  }

  /** What must not be, in the order in which it was seen. */
  synchronized List<String> faults() {
    return List.copyOf(faults);
  }
}
