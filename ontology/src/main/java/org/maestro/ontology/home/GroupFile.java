package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.NodeFactory;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.validation.SourceReader;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.VocabularyCheck;

/**
 * A file that describes a room's agent, or another agent of a group, and its devices, as a home
 * file does, to be added to a home that runs already (ADE, 6; A96). Rooms, topics and devices that
 * it names may stand in the home. Never uses the network.
 */
public final class GroupFile {
  private static final String BASE = "https://w3id.org/maestro/member/";
  private static final Node HEARS = Maestro.term("hears");
  private static final String GROUP = "GroupAgent";
  private static final String DEVICE = "Device";
  private static final String ROOM = "Room";

  private final Home home;

  /**
   * The parts of a file.
   *
   * @param groups in the order of the file
   * @param devices what it says of devices, as text; blank: nothing
   */
  public record Parts(List<Group> groups, String devices) {
    public Parts {
      groups = List.copyOf(groups);
    }
  }

  /**
   * @param home to which it is added
   */
  public GroupFile(Home home) {
    this.home = home;
  }

  /**
   * Reads a text; one without groups is of devices alone, and left as it is.
   *
   * @param name how faults call it, such as {@code study.ttl}
   * @throws HomeFaultException with every fault that was found in what it says of groups
   */
  public Parts read(String text, String name) {
    if (DescriptionReader.isJson(text)) {
      return new Parts(List.of(), text);
    }
    SourceGraph graph = new SourceGraph();
    new SourceReader(graph, name, BASE + "#").readTurtle(text);
    refuseFaults(graph);
    Set<Node> nodes = new LinkedHashSet<>();
    graph.subjects().stream().filter(node -> isGroup(graph, node)).forEach(nodes::add);
    if (nodes.isEmpty()) {
      return new Parts(List.of(), text);
    }
    String devices = withoutGroups(graph, nodes);
    return new Parts(groups(graph, nodes), devices);
  }

  private boolean isGroup(SourceGraph graph, Node node) {
    return node.isURI()
        && graph.objects(node, RDF.type.asNode()).stream()
            .map(Literals::name)
            .anyMatch(name -> name.equals(GROUP) || home.vocabulary().isA(name, GROUP));
  }

  private List<Group> groups(SourceGraph graph, Set<Node> nodes) {
    nodes.forEach(node -> tellOfMembers(graph, node));
    VocabularyCheck words = new VocabularyCheck(graph, home.vocabulary(), name -> true);
    Aims aims = new Aims(graph, home.vocabulary(), words, home.scripts()::containsKey);
    IndividualReader individuals = new IndividualReader(graph, home.vocabulary());
    Map<String, Group> groups = new LinkedHashMap<>();
    Home whole = home;
    Map<String, Node> nodeByName = new TreeMap<>();
    home.groups()
        .forEach(
            (id, group) -> nodeByName.put(id, NodeFactory.createURI(group.individual().iri())));
    for (Node node : nodes) {
      Individual individual = individuals.read(node);
      if (home.individuals().containsKey(individual.name())) {
        graph.fault(node, "has the name of something else in the home", "give it another name");
      } else {
        Group group = aims.group(node, individual);
        group.hearing().ifPresent(hearing -> checkRooms(graph, node, hearing));
        groups.put(group.id(), group);
        nodeByName.put(group.id(), node);
        whole = whole.with(group);
      }
    }
    refuseFaults(graph);
    new GroupCheck(graph, whole).check(nodeByName);
    refuseFaults(graph);
    return new ArrayList<>(groups.values());
  }

  /** Devices that the file names may be described in the home. */
  private void tellOfMembers(SourceGraph graph, Node node) {
    for (Node member : graph.objects(node, Maestro.term("member"))) {
      if (home.devices().containsKey(Literals.name(member))) {
        graph.state(member, RDF.type.asNode(), Maestro.term(DEVICE));
      }
    }
  }

  private void checkRooms(SourceGraph graph, Node node, RoomHearing hearing) {
    if (hearing.rooms().isEmpty()) {
      graph.fault(
          node,
          HEARS,
          Optional.empty(),
          "is not stated",
          "name the room in which it hears what is said");
    }
    for (Node named : graph.objects(node, HEARS)) {
      Individual room = home.individuals().get(Literals.name(named));
      if (room == null || !room.classes().contains(ROOM)) {
        graph.fault(
            node, HEARS, Optional.of(named), "is no room", "name a maestro:Room of the home");
      }
      home.listener(Literals.name(named))
          .ifPresent(
              other ->
                  graph.fault(
                      node,
                      HEARS,
                      Optional.of(named),
                      "is a room in which %s hears what is said".formatted(other.id()),
                      "name another, or remove that agent first"));
    }
  }

  private static String withoutGroups(SourceGraph whole, Set<Node> groups) {
    SourceGraph devices = new SourceGraph();
    devices.copyPrefixes(whole);
    whole.subjects().stream()
        .filter(subject -> subject.isURI() && !groups.contains(subject))
        .forEach(subject -> devices.copyAbout(subject, whole));
    return devices.subjects().isEmpty() ? "" : devices.turtle();
  }

  private static void refuseFaults(SourceGraph graph) {
    if (!graph.faults().isEmpty()) {
      throw new HomeFaultException(graph.faults());
    }
  }
}
