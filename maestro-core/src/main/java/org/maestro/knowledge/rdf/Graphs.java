package org.maestro.knowledge.rdf;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.apache.jena.datatypes.xsd.XSDDatatype;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.NodeFactory;
import org.apache.jena.graph.Triple;
import org.apache.jena.sparql.core.Quad;
import org.apache.jena.vocabulary.OWL2;
import org.apache.jena.vocabulary.RDF;
import org.apache.jena.vocabulary.RDFS;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.knowledge.belief.Outcome;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * Knowledge as RDF. Graphs: {@code vocabulary}, {@code home}, one per member, {@code world} with
 * the current facts, each pointing to its observation, and {@code observations} with who said what,
 * when and how surely, in the words of SOSA and PROV.
 */
public final class Graphs {

  private static final String MAESTRO = "https://w3id.org/maestro#";
  private static final String SOSA = "http://www.w3.org/ns/sosa/";
  private static final String PROV = "http://www.w3.org/ns/prov#";
  private static final int PAIR = 2;

  /** Made once: each statement has them, and the dataset keeps what it is given. */
  private static final Node FACT = maestro("fact");

  private static final Node OBSERVATION = sosa("Observation");
  private static final Node ACTIVITY = prov("Activity");
  private static final Node OBSERVED_PROPERTY = sosa("observedProperty");
  private static final Node HAS_FEATURE_OF_INTEREST = sosa("hasFeatureOfInterest");
  private static final Node HAS_SIMPLE_RESULT = sosa("hasSimpleResult");
  private static final Node RESULT_TIME = sosa("resultTime");
  private static final Node WAS_ATTRIBUTED_TO = prov("wasAttributedTo");
  private static final Node SOURCE_NAME = maestro("sourceName");
  private static final Node SOURCE_KIND = maestro("sourceKind");
  private static final Node CONFIDENCE = maestro("confidence");

  private final Home home;
  private final Node worldGraph;
  private final Node observationsGraph;

  public Graphs(Home home) {
    this.home = home;
    this.worldGraph = graph("world");
    this.observationsGraph = graph("observations");
  }

  public Node vocabularyGraph() {
    return graph("vocabulary");
  }

  public Node homeGraph() {
    return graph("home");
  }

  public Node worldGraph() {
    return worldGraph;
  }

  public Node observationsGraph() {
    return observationsGraph;
  }

  public Node memberGraph(String member) {
    return graph("member/" + member);
  }

  public Node observation(long serial) {
    return NodeFactory.createURI(home.iri() + "observation-" + serial);
  }

  public List<Triple> vocabulary() {
    Vocabulary vocabulary = home.vocabulary();
    List<Triple> triples = new ArrayList<>();
    vocabulary
        .classes()
        .values()
        .forEach(
            type -> {
              declare(triples, type.iri(), OWL2.Class.asNode(), type.label());
              type.ancestors().stream()
                  .filter(ancestor -> !ancestor.equals(type.name()))
                  .forEach(
                      ancestor ->
                          triples.add(
                              Triple.create(
                                  NodeFactory.createURI(type.iri()),
                                  RDFS.subClassOf.asNode(),
                                  classNode(ancestor))));
            });
    vocabulary
        .predicates()
        .values()
        .forEach(
            p ->
                declare(triples, p.iri(), maestro(p.fluent() ? "Fluent" : "Predicate"), p.label()));
    vocabulary
        .features()
        .values()
        .forEach(
            f -> declare(triples, f.iri(), maestro(f.task() ? "Task" : "Action"), f.sentence()));
    return triples;
  }

  public List<Triple> individual(Individual individual) {
    List<Triple> triples = new ArrayList<>();
    Node subject = NodeFactory.createURI(individual.iri());
    triples.add(Triple.create(subject, RDFS.label.asNode(), text(individual.label())));
    individual
        .classes()
        .forEach(name -> triples.add(Triple.create(subject, RDF.type.asNode(), classNode(name))));
    individual
        .properties()
        .forEach(
            (property, values) ->
                values.forEach(
                    v -> triples.add(Triple.create(subject, predicate(property), node(v)))));
    return triples;
  }

  /**
   * What a current belief puts into the world's graph: its text, and its plain triple where it has
   * one.
   */
  public List<Quad> current(Outcome.News news) {
    List<Quad> quads = new ArrayList<>();
    quads.add(
        Quad.create(worldGraph(), observation(news.held().serial()), FACT, text(news.fact())));
    plain(news).ifPresent(triple -> quads.add(Quad.create(worldGraph(), triple)));
    return quads;
  }

  public List<Quad> provenance(Outcome.News news) {
    Node observation = observation(news.held().serial());
    Source source = news.held().source();
    Instant since = news.held().since();
    List<Quad> quads = new ArrayList<>();
    boolean seen = source.kind() != Source.Kind.EXPECTED;
    add(quads, observation, RDF.type.asNode(), seen ? OBSERVATION : ACTIVITY);
    add(quads, observation, FACT, text(news.fact()));
    add(quads, observation, OBSERVED_PROPERTY, predicate(news.variable().predicate()));
    news.variable().arguments().stream()
        .findFirst()
        .ifPresent(s -> add(quads, observation, HAS_FEATURE_OF_INTEREST, node(s)));
    if (news.has()) {
      add(quads, observation, HAS_SIMPLE_RESULT, node(news.held().value()));
    }
    add(
        quads,
        observation,
        RESULT_TIME,
        NodeFactory.createLiteralDT(since.toString(), XSDDatatype.XSDdateTime));
    add(quads, observation, WAS_ATTRIBUTED_TO, node(new Term.Name(source.agent())));
    add(quads, observation, SOURCE_NAME, text(source.agent()));
    add(quads, observation, SOURCE_KIND, text(source.kind().name()));
    add(quads, observation, CONFIDENCE, node(new Term.Number(news.held().confidence())));
    return quads;
  }

  /** All statements that are kept, and which of them are believed. */
  public String statementsQuery() {
    return """
    SELECT ?statement ?fact ?agent ?kind ?time ?confidence ?believed WHERE {
      GRAPH <%s> {
        ?statement <%sfact> ?fact ; <%ssourceName> ?agent ; <%ssourceKind> ?kind ;
          <%sresultTime> ?time ; <%sconfidence> ?confidence }
      OPTIONAL { GRAPH <%s> { ?statement <%sfact> ?believed } } }
    """
        .formatted(
            observationsGraph().getURI(),
            MAESTRO,
            MAESTRO,
            MAESTRO,
            SOSA,
            MAESTRO,
            worldGraph().getURI(),
            MAESTRO);
  }

  /** The graphs in which members are described. */
  public String membersQuery() {
    return "SELECT DISTINCT ?graph WHERE { GRAPH ?graph { ?s ?p ?o } FILTER(STRSTARTS(STR(?graph), \"%s\")) }"
        .formatted(memberGraph("").getURI());
  }

  private Optional<Triple> plain(Outcome.News news) {
    StateVariable variable = news.variable();
    boolean isAtom = news.held().value() instanceof Term.Truth;
    if (!news.has() || news.held().value().equals(new Term.Truth(false))) {
      return Optional.empty();
    }
    List<Term> terms =
        isAtom && variable.arguments().size() > 1
            ? variable.arguments()
            : variable.with(news.held().value());
    return terms.size() == PAIR
        ? Optional.of(
            Triple.create(node(terms.get(0)), predicate(variable.predicate()), node(terms.get(1))))
        : Optional.empty();
  }

  private void add(List<Quad> quads, Node subject, Node predicate, Node object) {
    quads.add(Quad.create(observationsGraph(), subject, predicate, object));
  }

  private static void declare(List<Triple> triples, String iri, Node type, String label) {
    Node subject = NodeFactory.createURI(iri);
    triples.add(Triple.create(subject, RDF.type.asNode(), type));
    triples.add(Triple.create(subject, RDFS.label.asNode(), text(label)));
  }

  private Node classNode(String name) {
    return Optional.ofNullable(home.vocabulary().classes().get(name))
        .map(type -> NodeFactory.createURI(type.iri()))
        .orElseGet(() -> maestro(name));
  }

  private Node predicate(String name) {
    return home.vocabulary()
        .predicate(name)
        .map(p -> NodeFactory.createURI(p.iri()))
        .orElseGet(() -> maestro(name));
  }

  private Node node(Term term) {
    if (term instanceof Term.Name name) {
      Individual individual = home.individuals().get(name.text());
      return NodeFactory.createURI(
          individual == null ? home.iri() + name.text() : individual.iri());
    } else if (term instanceof Term.Iri iri) {
      return NodeFactory.createURI(iri.text());
    } else if (term instanceof Term.Number number) {
      return NodeFactory.createLiteralDT(SlPrinter.print(number.value()), XSDDatatype.XSDdouble);
    } else if (term instanceof Term.Truth truth) {
      return NodeFactory.createLiteralDT(String.valueOf(truth.value()), XSDDatatype.XSDboolean);
    }
    return text(((Term.Text) term).value());
  }

  private Node graph(String name) {
    return NodeFactory.createURI(home.iri() + "graph/" + name);
  }

  private static Node text(String value) {
    return NodeFactory.createLiteralString(value);
  }

  private static Node maestro(String name) {
    return NodeFactory.createURI(MAESTRO + name);
  }

  private static Node sosa(String name) {
    return NodeFactory.createURI(SOSA + name);
  }

  private static Node prov(String name) {
    return NodeFactory.createURI(PROV + name);
  }
}
