package org.maestro.bench.losses;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.assembly.BusWitness;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;

/**
 * A broker and presses that stamp letters, each of which can be stamped by one press only. The
 * first letter that a press gets takes until its gate is opened; the others are stamped at once. A
 * press counts what it does.
 */
public final class PostOffice implements AutoCloseable {
  public static final String SITE = "post";

  private final EmbeddedBroker broker = EmbeddedBroker.start();
  private final PacedClock clock = new PacedClock(1);
  private final Map<String, Integer> stampsByLetter = new TreeMap<>();
  private final Map<String, Integer> startsByCall = new TreeMap<>();
  private final Map<String, Execution> atTheGate = new TreeMap<>();
  private final Map<String, String> firstAt = new TreeMap<>();
  private final List<RatsMember> presses = new ArrayList<>();
  private final List<Integer> lettersByPress;
  private final BusWitness witness;

  /**
   * @param lettersByPress how many letters each press has to stamp
   */
  public PostOffice(List<Integer> lettersByPress) {
    this.lettersByPress = lettersByPress;
    this.witness = BusWitness.listen(new PahoTransport(broker.uri(), "witness"), SITE);
    Home home = new HomeLoader().load(homeText(), "post.ttl");
    DescriptionWriter descriptions = new DescriptionWriter(home);
    for (int number = 0; number < lettersByPress.size(); number++) {
      String id = "press-" + number;
      Device press = Objects.requireNonNull(home.devices().get(id));
      presses.add(press(id, descriptions.write(press)));
    }
  }

  public String broker() {
    return broker.uri().toString();
  }

  /**
   * The words of a command line that starts a platform without simulated devices on its broker.
   *
   * @param home the file with its text
   * @param data the directory of the platform's journal
   */
  public List<String> platform(Path home, Path data, int port) {
    return List.of(
        "run",
        home.toString(),
        "--no-sim",
        "--broker",
        broker(),
        "--data",
        data.toString(),
        "--port",
        String.valueOf(port),
        "--name",
        SITE);
  }

  public BusWitness witness() {
    return witness;
  }

  public List<String> letters() {
    List<String> letters = new ArrayList<>();
    for (int press = 0; press < lettersByPress.size(); press++) {
      for (int letter = 0; letter < lettersByPress.get(press); letter++) {
        letters.add("letter-" + press + "-" + letter);
      }
    }
    return letters;
  }

  public String homeText() {
    StringBuilder text =
        new StringBuilder(
            """
            @prefix : <https://w3id.org/maestro/domain#> .
            @prefix home: <https://w3id.org/maestro/home/post#> .
            @prefix maestro: <https://w3id.org/maestro#> .
            @prefix owl: <http://www.w3.org/2002/07/owl#> .
            @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
            <https://w3id.org/maestro/home/post> a maestro:Home ; rdfs:label "a post office"@en .
            :Letter a owl:Class ; rdfs:subClassOf maestro:Thing ; rdfs:label "letter"@en .
            :stamped a maestro:Predicate ; rdfs:label "stamped"@en ;
              maestro:arguments ( "?l - Letter" ) .
            :madeFor a maestro:Predicate ; rdfs:label "made for"@en ;
              maestro:arguments ( "?p - Press" "?l - Letter" ) .
            :stamp a maestro:Task ; rdfs:label "stamp"@en ; maestro:order 500 ;
              maestro:sentence "{self} stamps {letter}" ;
              maestro:input [ maestro:name "letter" ; maestro:type :Letter ] ;
              maestro:precondition "(and (madeFor ?self ?letter) (not (stamped ?letter)))" ;
              maestro:effect "(stamped ?letter)" ;
              maestro:occupies ( "plate" ) ; maestro:cost "1" ; maestro:seconds "60" .
            :Press a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "press"@en ;
              maestro:offers :stamp ;
              maestro:reports [ maestro:name "stamped" ; maestro:fact "(stamped ?stamped)" ] .
            """);
    for (int press = 0; press < lettersByPress.size(); press++) {
      text.append("home:press-%1$d a :Press ; maestro:order %1$d".formatted(press));
      for (int letter = 0; letter < lettersByPress.get(press); letter++) {
        text.append(" ;\n  :madeFor home:letter-%d-%d".formatted(press, letter));
      }
      text.append(" .\n");
    }
    letters().forEach(letter -> text.append("home:%s a :Letter .%n".formatted(letter)));
    return text.toString();
  }

  private RatsMember press(String id, String description) {
    Procedure stamping =
        new Procedure() {
          @Override
          public void start(Execution execution) {
            begun(id, execution);
          }

          @Override
          public CostAnswer cost(Map<String, Object> parameters) {
            return new CostAnswer(Optional.of(1.0), Optional.of(1.0), Optional.empty());
          }
        };
    MemberProfile.Feature stamp =
        new MemberProfile.Feature(
            "stamp", Set.of("letter"), Set.of("plate"), false, Optional.empty(), "busy", stamping);
    MemberProfile profile =
        new MemberProfile(
            id,
            description,
            Set.of("calm", "busy"),
            "calm",
            Set.of("calm"),
            Map.of("stamp", stamp));
    return RatsMember.start(
        profile,
        () -> stampedBy(id),
        new PahoTransport(broker.uri(), SITE + "-" + id),
        SITE,
        clock);
  }

  private synchronized void begun(String press, Execution execution) {
    startsByCall.merge(execution.call().id(), 1, Integer::sum);
    String letter = letterOf(execution);
    if (firstAt.computeIfAbsent(press, first -> letter).equals(letter)) {
      atTheGate.put(press, execution);
      execution.onCancel(
          safe -> {
            leave(press, execution);
            safe.run();
          });
    } else {
      clock.schedule(Duration.ofMillis(5), press, () -> stamped(execution));
    }
  }

  private synchronized void leave(String press, Execution cancelled) {
    atTheGate.remove(press, cancelled);
  }

  /** What was cancelled meanwhile is not done. */
  private synchronized void stamped(Execution execution) {
    if (execution.ended()) {
      return;
    }
    stampsByLetter.merge(letterOf(execution), 1, Integer::sum);
    execution.succeed(Map.of());
  }

  private static String letterOf(Execution execution) {
    Object pointer = execution.call().parameters().get("letter");
    String iri = pointer instanceof Map<?, ?> map ? String.valueOf(map.get("ref")) : "";
    return iri.substring(iri.indexOf('#') + 1);
  }

  private synchronized List<String> stampedBy(String press) {
    String prefix = press.replace("press", "letter") + "-";
    return stampsByLetter.keySet().stream()
        .filter(letter -> letter.startsWith(prefix))
        .map(letter -> "(stamped " + letter + ")")
        .toList();
  }

  /** The presses that wait at their gates. */
  public synchronized Set<String> atTheGate() {
    return Set.copyOf(atTheGate.keySet());
  }

  /** Lets through what waits there now, if anything does. */
  public synchronized void open(String press) {
    Optional.ofNullable(atTheGate.remove(press))
        .ifPresent(waiting -> clock.schedule(Duration.ZERO, press, () -> stamped(waiting)));
  }

  public synchronized Map<String, Integer> stampsByLetter() {
    return new LinkedHashMap<>(stampsByLetter);
  }

  public synchronized Map<String, Integer> startsByCall() {
    return new LinkedHashMap<>(startsByCall);
  }

  @Override
  public void close() {
    witness.close();
    presses.forEach(RatsMember::close);
    clock.close();
    broker.close();
  }
}
