package org.maestro.sim.scene;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.apache.jena.graph.Node;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.validation.Nearest;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.validation.SourceReader;
import org.maestro.ontology.vocabulary.NameCheck;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/** What a scene's text says of each thing, word by word, with the lines and the faults so far. */
final class SceneText {

  /** Of what is said of the home itself; no thing has this name. */
  static final String HOME = "";

  /** The word with which anything may be said of a thing. */
  private static final String STATE = "state";

  private final String name;
  private final Home home;
  private final Collection<Home> others;
  private final SourceGraph graph = new SourceGraph();
  private final Map<String, Map<String, String>> words = new TreeMap<>();
  private final Map<String, List<String>> states = new TreeMap<>();
  private final Map<String, Map<String, Integer>> lines = new TreeMap<>();
  private final List<Fault> faults = new ArrayList<>();
  private final Set<String> strangers = new TreeSet<>();

  /**
   * @param name how faults call the text
   */
  SceneText(String name, String turtle, Home home) {
    this(name, turtle, home, List.of());
  }

  /**
   * @param others homes of which the same text speaks: what is said of things that they alone have
   *     is left out
   */
  SceneText(String name, String turtle, Home home, Collection<Home> others) {
    this.name = name;
    this.home = home;
    this.others = List.copyOf(others);
    new SourceReader(graph, name, home.iri()).readTurtle(turtle);
    faults.addAll(graph.faults());
    for (Node subject : graph.subjects()) {
      for (Node property : graph.predicates(subject)) {
        graph.objects(subject, property).forEach(value -> read(subject, property, value));
      }
    }
  }

  private void read(Node subject, Node property, Node value) {
    int line = graph.told(subject, property, Optional.of(value), "", "").line();
    if (!property.getURI().startsWith(SceneLoader.NAMESPACE)) {
      fault(
          line,
          "uses the property <%s>; a scene knows words of scene: only"
              .formatted(property.getURI()));
    } else if (!value.isLiteral()) {
      fault(
          line,
          "gives scene:%s a value that is no literal; write a text or a number"
              .formatted(word(property)));
    } else {
      thing(subject, line).ifPresent(thing -> note(thing, word(property), value, line));
    }
  }

  private static String word(Node property) {
    return property.getURI().substring(SceneLoader.NAMESPACE.length());
  }

  private void note(String thing, String word, Node value, int line) {
    if (word.equals(STATE)) {
      noteState(thing, value.getLiteralLexicalForm(), line);
      return;
    }
    String former =
        words
            .computeIfAbsent(thing, key -> new TreeMap<>())
            .putIfAbsent(word, value.getLiteralLexicalForm());
    lines.computeIfAbsent(thing, key -> new TreeMap<>()).putIfAbsent(word, line);
    if (former != null) {
      fault(line, "gives " + thing + " two values of scene:" + word + "; keep one");
    }
  }

  private boolean isA(String name, String type) {
    return Optional.ofNullable(home.individuals().get(name))
        .filter(thing -> thing.classes().contains(type))
        .isPresent();
  }

  /** Several may be said of a thing. */
  private void noteState(String thing, String state, int line) {
    lines.computeIfAbsent(thing, key -> new TreeMap<>()).putIfAbsent(STATE, line);
    List<String> problems = new ArrayList<>();
    try {
      new NameCheck(
              home.vocabulary(),
              home.individuals()::containsKey,
              this::isA,
              Map.of(),
              NameCheck::declare,
              (problem, cure) -> problems.add(problem + "; " + cure))
          .check(SlParser.fact(state));
    } catch (SlSyntaxException e) {
      problems.add(
          "is no fact: at column %d stands %s; write %s there"
              .formatted(e.column(), e.found(), e.expected()));
    }
    if (problems.isEmpty()) {
      states.computeIfAbsent(thing, key -> new ArrayList<>()).add(state);
    } else {
      fault(line, "says scene:state \"%s\", which %s".formatted(state, problems.get(0)));
    }
  }

  private Optional<String> thing(Node subject, int line) {
    String iri = subject.isURI() ? subject.getURI() : subject.toString();
    if (iri.equals(home.iri()) || others.stream().anyMatch(other -> iri.equals(other.iri()))) {
      return Optional.of(HOME);
    }
    String local = iri.substring(Math.max(iri.lastIndexOf('#'), iri.lastIndexOf('/')) + 1);
    if (home.individuals().containsKey(local)) {
      return Optional.of(local);
    }
    boolean isElsewhere = others.stream().anyMatch(other -> other.individuals().containsKey(local));
    if (!isElsewhere && strangers.add(local)) {
      fault(
          line,
          "speaks of %s, which the home does not have; %s"
              .formatted(
                  local,
                  Nearest.cure(
                      local,
                      home.individuals().keySet(),
                      "it has " + String.join(", ", home.individuals().keySet()))));
    }
    return Optional.empty();
  }

  /** What else is so of each thing, facts in MAESTRO-SL. */
  Map<String, List<String>> states() {
    return states;
  }

  /** Values by thing and word. */
  Map<String, Map<String, String>> words() {
    return words;
  }

  /** The line of what is said of a thing, of this word if it is said; 1 when nothing is. */
  int line(String thing, String word) {
    Map<String, Integer> ofThing = lines.getOrDefault(thing, Map.of());
    return ofThing.getOrDefault(
        word, ofThing.values().stream().mapToInt(line -> line).min().orElse(1));
  }

  /** What is wrong so far. */
  List<Fault> faults() {
    return faults;
  }

  /**
   * @param sentence without its subject; a cure may stand behind a semicolon
   */
  Fault told(int line, String sentence) {
    String[] parts = sentence.split("; ", 2);
    return new Fault(
        name, line, "the scene", "", parts[0], parts.length > 1 ? parts[1] : "correct it");
  }

  private void fault(int line, String sentence) {
    faults.add(told(line, sentence));
  }
}
