package org.maestro.ontology.home;

import java.time.DateTimeException;
import java.time.ZoneId;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.NodeFactory;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.ontology.vocabulary.VocabularyCheck;
import org.maestro.ontology.wording.WordingReader;
import org.maestro.sl.Point;

/** Reads the home of a graph: its things, its devices, its scripts and its rules. */
final class HomeReader {

  private static final String HOME = "Home";
  private static final String ROOM = "Room";
  private static final String ZONE = "Zone";

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final String source;

  HomeReader(SourceGraph graph, Vocabulary vocabulary, String source) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.source = source;
  }

  Home read() {
    Map<String, Individual> individuals = new TreeMap<>();
    Map<String, Node> nodes = new TreeMap<>();
    IndividualReader reader = new IndividualReader(graph, vocabulary);
    List<Node> homes = graph.subjects(RDF.type.asNode(), Maestro.term(HOME));
    for (Node subject : graph.subjectsOf(source)) {
      if (subject.isURI()
          && !homes.contains(subject)
          && !isAWord(subject)
          && !ScriptReader.isScript(graph, subject)
          && !RuleReader.isRule(graph, subject)) {
        Individual individual = reader.read(subject);
        checkName(subject, individual.name(), nodes);
        individuals.put(individual.name(), individual);
      }
    }
    Map<String, Node> scripts = scripts(nodes);
    Map<String, Node> rules = rules(nodes, scripts);
    roomsAsZones(individuals);
    Map<Point, Node> points = points(individuals, homes);
    VocabularyCheck words = new VocabularyCheck(graph, vocabulary, individuals::containsKey);
    words.check();
    Node homeNode = homeNode(homes);
    Home home =
        new Home(
            homeNode.isURI() ? homeNode.getURI() : "",
            new Literals(graph).label(homeNode),
            vocabulary,
            individuals,
            devices(individuals, nodes, words),
            groups(individuals, nodes, words, scripts.keySet()),
            readScripts(scripts),
            readRules(rules),
            timeZone(homeNode),
            new WordingReader(graph, vocabulary).read(),
            ownWords(homeNode),
            Optional.of(source.substring(source.lastIndexOf('/') + 1)),
            new TrackingReader(graph, vocabulary, words).read(individuals, nodes));
    check(home, nodes, scripts);
    new RuleCheck(graph, home).check(rules);
    checkMap(home, points);
    return home;
  }

  /** The points that formulas of the text name are things of the home. */
  private Map<Point, Node> points(Map<String, Individual> individuals, List<Node> homes) {
    Map<Point, Node> points = new PointReader(graph, source).read();
    String home = homes.stream().filter(Node::isURI).map(Node::getURI).findFirst().orElse("");
    points
        .keySet()
        .forEach(
            point ->
                individuals.putIfAbsent(
                    point.name(), NamedPoints.individual(point, home, vocabulary)));
    return points;
  }

  /** The scripts of the text, whose names are neither things' nor words', and the shipped ones. */
  private Map<String, Node> scripts(Map<String, Node> things) {
    Map<String, Node> taken = new TreeMap<>(things);
    Map<String, Node> scripts = new TreeMap<>();
    for (Node subject : graph.subjectsOf(source)) {
      if (subject.isURI() && ScriptReader.isScript(graph, subject)) {
        checkName(subject, Literals.name(subject), taken);
        scripts.put(Literals.name(subject), subject);
      }
    }
    graph
        .subjects(RDF.type.asNode(), Maestro.term("Script"))
        .forEach(shipped -> scripts.putIfAbsent(Literals.name(shipped), shipped));
    return scripts;
  }

  private Map<String, Script> readScripts(Map<String, Node> nodes) {
    ScriptReader reader = new ScriptReader(graph, vocabulary, nodes.keySet());
    Map<String, Script> scripts = new TreeMap<>();
    nodes.forEach((name, node) -> scripts.put(name, reader.read(node)));
    return scripts;
  }

  /** The rules of the text, whose names are neither things' nor words' nor scripts'. */
  private Map<String, Node> rules(Map<String, Node> things, Map<String, Node> scripts) {
    Map<String, Node> taken = new TreeMap<>(things);
    taken.putAll(scripts);
    Map<String, Node> rules = new TreeMap<>();
    for (Node subject : graph.subjectsOf(source)) {
      if (subject.isURI() && RuleReader.isRule(graph, subject)) {
        checkName(subject, Literals.name(subject), taken);
        rules.put(Literals.name(subject), subject);
      }
    }
    return rules;
  }

  private Map<String, Rule> readRules(Map<String, Node> nodes) {
    RuleReader reader = new RuleReader(graph, vocabulary);
    Map<String, Rule> rules = new TreeMap<>();
    nodes.forEach((name, node) -> reader.read(node).ifPresent(rule -> rules.put(name, rule)));
    return rules;
  }

  private Optional<ZoneId> timeZone(Node home) {
    Optional<String> named = new Literals(graph).text(home, "timeZone");
    try {
      return named.map(ZoneId::of);
    } catch (DateTimeException e) {
      Node property = Maestro.term("timeZone");
      graph.fault(
          home,
          property,
          graph.object(home, property),
          "is no time zone",
          "name one such as \"Europe/Berlin\"");
      return Optional.empty();
    }
  }

  private String ownWords(Node home) {
    SourceGraph own = new SourceGraph();
    HouseholdWords.note(own, graph, home);
    graph.subjectsOf(source).stream()
        .filter(subject -> subject.isURI() && isAWord(subject))
        .forEach(subject -> own.copyStated(subject, source, graph));
    return own.subjects().isEmpty() ? "" : own.turtle();
  }

  private Map<String, Device> devices(
      Map<String, Individual> individuals, Map<String, Node> nodes, VocabularyCheck words) {
    DeviceReader reader = new DeviceReader(graph, vocabulary, words);
    Map<String, Device> devices = new TreeMap<>();
    nodes.forEach(
        (name, node) -> {
          Individual individual = HomeCheck.named(individuals, name);
          if (individual.classes().contains("Device")) {
            devices.put(name, reader.read(node, individual));
          }
        });
    return devices;
  }

  private Map<String, Group> groups(
      Map<String, Individual> individuals,
      Map<String, Node> nodes,
      VocabularyCheck words,
      Set<String> scripts) {
    Aims aims = new Aims(graph, vocabulary, words, scripts::contains);
    Map<String, Group> groups = new TreeMap<>();
    nodes.forEach(
        (name, node) -> {
          Individual individual = HomeCheck.named(individuals, name);
          if (individual.classes().contains("GroupAgent")) {
            groups.put(name, aims.group(node, individual));
          }
        });
    return groups;
  }

  /** Thing by thing. */
  private void check(Home home, Map<String, Node> nodes, Map<String, Node> scripts) {
    HomeCheck check = new HomeCheck(graph, vocabulary);
    nodes.forEach(
        (name, node) -> {
          check.checkThing(node, isAgent(home, name));
          if (graph.isA(NodeFactory.createURI(home.iri()), Maestro.term(HOME))) {
            check.checkHomeDeclares(node);
          }
        });
    home.devices()
        .forEach(
            (name, device) -> {
              Node node = HomeCheck.named(nodes, name);
              check.checkUse(node, device);
              check.checkReported(node, device);
            });
    new PermissionCheck(graph, home).check(nodes);
    scripts.values().forEach(check::checkScript);
    new ScriptCheck(graph, home).check(scripts);
    new GroupCheck(graph, home).check(nodes);
  }

  /** The map as a whole, if nothing was wrong before. */
  private void checkMap(Home home, Map<Point, Node> points) {
    if (graph.faults().isEmpty()) {
      new MapCheck(graph, home).check();
      points.forEach(
          (point, node) ->
              new NamedPoints(Set.of(point))
                  .objection(home)
                  .ifPresent(found -> graph.fault(node, found.problem(), found.cure())));
    }
  }

  private static boolean isAgent(Home home, String name) {
    return home.devices().containsKey(name)
        || home.groups().containsKey(name)
        || home.tracking().filter(tracking -> tracking.agent().equals(name)).isPresent();
  }

  private Node homeNode(List<Node> homes) {
    if (homes.size() == 1) {
      return homes.get(0);
    }
    Fault fault =
        new Fault(
            source,
            1,
            "the file",
            "",
            "describes " + (homes.isEmpty() ? "no home" : homes.size() + " homes"),
            "write one statement such as <https://w3id.org/maestro/home/mine> a maestro:Home");
    graph.fault(fault);
    return Maestro.term("");
  }

  /**
   * Whether the file declares a word with it, or says of somebody else's word how it is to be
   * understood, rather than describe a thing.
   */
  private boolean isAWord(Node subject) {
    return Alignment.isOnlyAligned(graph, subject)
        || isDeclared(subject)
        || WordingReader.isWording(graph, subject);
  }

  private boolean isDeclared(Node subject) {
    return vocabulary.iri(Literals.name(subject)).filter(subject.getURI()::equals).isPresent();
  }

  private void checkName(Node subject, String name, Map<String, Node> nodes) {
    Node other = nodes.putIfAbsent(name, subject);
    if (other != null) {
      graph.fault(subject, "has the local name of " + other.getURI(), "give it another name");
    }
    if (vocabulary.iri(name).isPresent()) {
      graph.fault(subject, "has the name of a word of the vocabulary", "give it another name");
    }
  }

  /** Without any zone, each room is one. */
  private static void roomsAsZones(Map<String, Individual> individuals) {
    if (individuals.values().stream().anyMatch(thing -> thing.classes().contains(ZONE))) {
      return;
    }
    individuals.replaceAll(
        (name, thing) -> {
          if (!thing.classes().contains(ROOM)) {
            return thing;
          }
          Set<String> classes = new TreeSet<>(thing.classes());
          classes.addAll(List.of(ZONE, "Place", "Location"));
          return new Individual(name, thing.iri(), thing.label(), classes, thing.properties());
        });
  }
}
