package org.maestro.ontology.wording;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.RDFS;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** Reads what words are called; what is wrong in it becomes faults of the graph. */
public final class WordingReader {
  private static final Node SAYS = Maestro.term("says");
  private static final Pattern ROLE = Pattern.compile("\\{([^{}]*)}");

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final Literals literals;

  public WordingReader(SourceGraph graph, Vocabulary vocabulary) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.literals = new Literals(graph);
  }

  /** Whether the node is a word of a language only, and no thing. */
  public static boolean isWording(SourceGraph graph, Node node) {
    return isA(graph, node, "Construction")
        || isA(graph, node, "State")
        || isA(graph, node, "Topic");
  }

  private static boolean isA(SourceGraph graph, Node node, String type) {
    return graph.isA(node, Maestro.term(type));
  }

  /** The words of all that the graph speaks of. */
  public Wording read() {
    Map<String, String> languages = new TreeMap<>();
    Map<String, List<Said>> names = new TreeMap<>();
    Map<String, List<Said>> prepositions = new TreeMap<>();
    Set<String> describing = new TreeSet<>();
    Map<String, Measure> measures = new TreeMap<>();
    List<StateWord> states = new ArrayList<>();
    List<Construction> constructions = new ArrayList<>();
    Map<String, Set<String>> topics = new TreeMap<>();
    Map<String, List<Said>> told = new TreeMap<>();
    for (Node subject : graph.subjects()) {
      if (!subject.isURI()) {
        continue;
      }
      String name = Literals.name(subject);
      literals
          .text(subject, "language")
          .ifPresent(tag -> languages.put(isA(graph, subject, "Home") ? Wording.HOME : name, tag));
      if (isA(graph, subject, "State")) {
        state(subject).ifPresent(states::add);
      } else if (isA(graph, subject, "Construction")) {
        construction(subject).ifPresent(constructions::add);
      } else if (isA(graph, subject, "Topic")) {
        topics.computeIfAbsent(name, topic -> new TreeSet<>()).addAll(included(subject));
      } else {
        List<Said> called = new ArrayList<>(said(subject, RDFS.label.asNode()));
        called.addAll(said(subject, Maestro.term("alsoCalled")));
        if (!called.isEmpty()) {
          names.put(name, called);
        }
        List<Said> relating = said(subject, Maestro.term("preposition"));
        if (!relating.isEmpty()) {
          prepositions.put(name, relating);
        }
        List<Said> sentences = said(subject, Maestro.term("told"));
        if (!sentences.isEmpty()) {
          told.put(name, sentences);
        }
        if (literals.flag(subject, "describes")) {
          describing.add(name);
        }
        if (vocabulary.isFluent(name)) {
          measures.put(name, measure(subject, name));
        }
      }
    }
    return new Wording(
        languages,
        names,
        prepositions,
        describing,
        measures,
        states,
        constructions,
        topics,
        told,
        Map.of());
  }

  private List<String> included(Node topic) {
    return graph.objects(topic, Maestro.term("includes")).stream().map(Literals::name).toList();
  }

  private Measure measure(Node node, String fluent) {
    return new Measure(
        fluent,
        literals.number(node, "step"),
        literals.number(node, "whole"),
        literals.number(node, "grain"),
        said(node, Maestro.term("more")),
        said(node, Maestro.term("less")),
        said(node, Maestro.term("howMuch")),
        literals.flag(node, "timeOfDay"));
  }

  private List<Said> said(Node node, Node property) {
    return graph.objects(node, property).stream()
        .filter(Node::isLiteral)
        .map(text -> new Said(text.getLiteralLexicalForm(), text.getLiteralLanguage()))
        .toList();
  }

  private Optional<StateWord> state(Node node) {
    Optional<String> of = literals.text(node, "of");
    Predicate<String> fluents = vocabulary::isFluent;
    Optional<Formula> holds =
        literals.parsed(node, "holdsWhen", text -> SlParser.formula(text, fluents));
    if (of.isEmpty() || !vocabulary.classes().containsKey(of.get())) {
      graph.fault(
          node,
          Maestro.term("of"),
          graph.object(node, Maestro.term("of")),
          "is no class",
          "name the class of what can be so, such as :Lamp");
      return Optional.empty();
    }
    if (holds.isEmpty()) {
      if (graph.object(node, Maestro.term("holdsWhen")).isEmpty()) {
        graph.fault(
            node,
            Maestro.term("holdsWhen"),
            Optional.empty(),
            "is missing",
            "write when ?it is so, such as \"(> (level ?it) 0)\"");
      }
      return Optional.empty();
    }
    return Optional.of(
        new StateWord(
            Literals.name(node),
            said(node, SAYS),
            of.get(),
            holds.get(),
            literals.parsed(node, "broughtAboutBy", text -> SlParser.formula(text, fluents)),
            said(node, Maestro.term("willBe"))));
  }

  private Optional<Construction> construction(Node node) {
    Predicate<String> fluents = vocabulary::isFluent;
    List<Construction.Role> roles = roles(node);
    Optional<Content> means =
        literals.parsed(node, "means", text -> SlParser.content(text, fluents).get(0));
    Optional<Formula> holds =
        literals.parsed(node, "holdsWhen", text -> SlParser.formula(text, fluents));
    checkRoles(node, roles);
    if (means.isEmpty() && holds.isEmpty()) {
      if (graph.object(node, Maestro.term("means")).isEmpty()) {
        graph.fault(
            node,
            Maestro.term("means"),
            Optional.empty(),
            "is missing",
            "write the message, such as \"(initCNP (:goal (= (level ?object) 1)))\"");
      }
      return Optional.empty();
    }
    return Optional.of(
        new Construction(
            Literals.name(node),
            said(node, SAYS),
            roles,
            means,
            holds,
            literals.flag(node, "early"),
            literals.flag(node, "confirm"),
            literals.flag(node, "inTheMorning")));
  }

  private void checkRoles(Node node, List<Construction.Role> roles) {
    for (Said pattern : said(node, SAYS)) {
      Matcher named = ROLE.matcher(pattern.text());
      while (named.find()) {
        String name = named.group(1);
        if (roles.stream().noneMatch(role -> role.name().equals(name))) {
          graph.fault(
              node,
              SAYS,
              Optional.empty(),
              "names the role {" + name + "}, which is not declared",
              "add maestro:role [ maestro:name \"" + name + "\" ; maestro:type ... ]");
        }
      }
    }
  }

  /**
   * What is said of a role in several places, such as its questions in another language, is one.
   */
  private List<Construction.Role> roles(Node construction) {
    Map<String, List<Node>> byName = new LinkedHashMap<>();
    for (Node role : graph.objects(construction, Maestro.term("role"))) {
      String name = literals.text(role, "name").orElse("");
      byName.computeIfAbsent(name, n -> new ArrayList<>()).add(role);
    }
    List<Construction.Role> roles = new ArrayList<>();
    byName.forEach((name, nodes) -> roles.add(role(name, nodes)));
    return roles;
  }

  private Construction.Role role(String name, List<Node> nodes) {
    return new Construction.Role(
        name,
        first(nodes, node -> literals.text(node, "type")).orElse("Thing"),
        first(nodes, node -> literals.text(node, "relates")),
        nodes.stream().flatMap(node -> said(node, Maestro.term("question")).stream()).toList(),
        nodes.stream().anyMatch(node -> literals.flag(node, "optional")),
        first(nodes, node -> literals.parsed(node, "usually", WordingReader::value)),
        nodes.stream().anyMatch(node -> literals.flag(node, "toTheEnd")));
  }

  private static <T> Optional<T> first(List<Node> nodes, Function<Node, Optional<T>> value) {
    return nodes.stream().map(value).flatMap(Optional::stream).findFirst();
  }

  private static Term value(String text) {
    return text.startsWith("?") ? new Term.Variable(text.substring(1)) : Term.named(text);
  }
}
