package org.maestro.console.faces;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import org.maestro.agents.faces.Faces;
import org.maestro.console.api.Operation;
import org.maestro.console.documents.FactsDocument;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.documents.ShownText;
import org.maestro.console.traffic.Source;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.MessageKind;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Message;

/**
 * What each face of the home tells of itself, at once: knowledge waits for the end of what a member
 * is at, and by then a sentence is over. Any thread may use it.
 */
public final class FaceStates implements Source {
  private final Topics topics;
  private final Supplier<Home> home;
  private final Supplier<ReadingRights> rights;
  private final WireFormat wire = new WireFormat();
  private final Map<String, Told> toldBy = new TreeMap<>();
  private long latest;

  /**
   * @param facts empty once it is gone
   * @param sentences how many it has begun to say
   * @param sentence the last of them, as a fact; "" before there is any
   */
  private record Told(long number, List<String> facts, int sentences, String sentence) {
    static final Told NOTHING = new Told(0, List.of(), 0, "");

    /** A sentence that goes on is not begun again. */
    Told then(long number, List<String> facts) {
      String said = saying(facts).orElse(sentence);
      boolean isBegun = saying(facts).isPresent() && !saying(facts).equals(saying(this.facts));
      return new Told(number, List.copyOf(facts), sentences + (isBegun ? 1 : 0), said);
    }

    private static Optional<String> saying(List<String> facts) {
      return facts.stream().filter(fact -> fact.startsWith("(isSaying ")).findFirst();
    }
  }

  /**
   * @param rights of all who look
   */
  public FaceStates(String site, Supplier<Home> home, Supplier<ReadingRights> rights) {
    this.topics = new Topics(site);
    this.home = home;
    this.rights = rights;
  }

  public Operation operation() {
    return Operation.get(
        "/faces",
        "faces",
        "What each face of the home shows now, as it tells it on the bus.",
        "faces",
        request -> CompletableFuture.completedFuture(all()));
  }

  /** What goes over the bus; of others than faces nothing is kept. */
  public void heard(Message message) {
    if (topics.kindOf(message.topic()).filter(MessageKind.STATE::equals).isPresent()) {
      topics
          .memberOf(message.topic())
          .filter(member -> face(member).isPresent())
          .ifPresent(member -> told(member, message.payload()));
    }
  }

  private Optional<Device> face(String member) {
    return Optional.ofNullable(home.get().devices().get(member)).filter(Faces::isFace);
  }

  /** Who leaves clears what it has told. */
  private void told(String member, byte[] payload) {
    try {
      keep(member, payload.length == 0 ? List.of() : wire.decodeState(payload).values());
    } catch (MalformedMessageException e) {
      // Whoever listens to the bus is told that it is none; the face stays as it was told last.
    }
  }

  private synchronized void keep(String member, List<String> facts) {
    Told before = toldBy.get(member);
    if (before == null || !before.facts().equals(facts)) {
      latest++;
      toldBy.put(member, (before == null ? Told.NOTHING : before).then(latest, facts));
    }
  }

  @Override
  public synchronized long latest() {
    return latest;
  }

  @Override
  public synchronized JsonNode between(long after, long last) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode faces = document.node().putArray("faces");
    toldBy.forEach(
        (member, told) -> {
          if (told.number() > after && told.number() <= last) {
            add(JsonMembers.in(faces), member, told);
          }
        });
    return document.node();
  }

  private void add(JsonMembers row, String member, Told told) {
    row.text("member", member)
        .text("label", ShownText.of(label(member)))
        .truth("there", !told.facts().isEmpty());
    ArrayNode facts = row.node().putArray("facts");
    ReadingRights all = rights.get();
    told.facts().stream()
        .filter(all::mayReadFact)
        .forEach(fact -> facts.add(FactsDocument.parts(fact)));
    row.number("sentences", OptionalInt.of(told.sentences()));
    if (!told.sentence().isEmpty() && all.mayReadFact(told.sentence())) {
      row.text("sentence", FactsDocument.parts(told.sentence()).at("/arguments/1").asText());
    }
  }

  private String label(String member) {
    return face(member).map(device -> device.individual().label()).orElse(member);
  }
}
