package org.maestro.knowledge.api;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.home.NamedPoints;

/** The store. Thread-safe; writes are atomic, each yields at most one change. */
public interface KnowledgeBase extends AutoCloseable {

  /** The home as it is now: the file's, and the devices that joined. */
  Home home();

  /** A device joined or sent a new description; it speaks only of itself. */
  void describe(Device device);

  /**
   * These are the home's permissions from now on, in the place of those before.
   *
   * @param permissions by their names
   */
  void permit(Map<String, Individual> permissions);

  /** The agent of a room, or of another group, is there from now on. */
  void admit(Group group);

  /** That agent of a group is there no more. */
  void dismiss(String group);

  /** Somebody speaks of these points; they are things of the home until nobody does any more. */
  void admit(NamedPoints points);

  /** Who spoke of these points does so no more; to be called once for each time before. */
  void dismiss(NamedPoints points);

  /**
   * Ground MAESTRO-SL facts said by a source: {@code (in rose zone-b)}, {@code (not (open
   * door-1))}, {@code (= (level lamp-b1) 0.5)}. A device states all its values each time: what it
   * leaves out is not known any more.
   */
  void state(Source source, List<String> facts);

  /**
   * The same, said by a member of itself: what a later message of its has told otherwise stays as
   * it is.
   */
  void state(String member, MemberWord word);

  /** What a member is at, from now on until it says otherwise or is lost. */
  void condition(String member, MemberCondition now);

  /**
   * What the source concludes, all that it believes now, each fact as surely as it says. What it
   * believed before and leaves out is not known on its word any more; what others are surer of
   * stands.
   *
   * @param sureness 0 to 1, by ground fact
   */
  void believe(Source source, Map<String, Double> sureness);

  /**
   * Writes what the result teaches: {@code learns}, or the effect, or {@code error.refs}. Returns
   * what that changed.
   */
  Change learn(FeatureRun run);

  /**
   * The member is gone: what it said of itself, and what was carried by it, become unknown; that it
   * is lost is known.
   */
  void lost(String member);

  /**
   * There is no plan because of these conditions: what was learnt of what settings give to numbers
   * in them counts no more until it is learnt anew, so that nothing is called impossible because
   * somebody has cleaned a lamp.
   *
   * @param conditions in MAESTRO-SL
   * @return whether anything had been learnt of such numbers
   */
  default boolean doubt(List<String> conditions) {
    return false;
  }

  Snapshot snapshot();

  /**
   * Who said what of what the fact speaks of, when and how surely, oldest first: for a functional
   * predicate all its values for the same thing. Statements that lost against another source are
   * among them, and those from before a restart if they were kept.
   *
   * @param fact a ground atom, or a fluent
   */
  List<Belief> history(String fact);

  /**
   * What was known last of what the fact speaks of, however long ago; empty when nothing ever was.
   *
   * @param fact a ground atom, or a fluent
   */
  Optional<Belief> lastKnown(String fact);

  /**
   * What a SPARQL SELECT finds in all that is known as RDF, with its provenance (Three-layered
   * architecture, 2; M12). It may wait for a store elsewhere.
   *
   * @throws KnowledgeException when it is no SPARQL, no SELECT, would ask others, or takes too long
   */
  QueryAnswer query(String sparql);

  /** Listeners are told after each change, on the writer's thread, and must hand over at once. */
  void watch(Consumer<Change> listener);

  @Override
  void close();

  /**
   * The changes made by one write.
   *
   * @param facts the new beliefs, and {@code (unknown ...)} for what was lost, in MAESTRO-SL
   * @param expected those of them that nobody has reported: they follow from what a step is for
   * @param denials what a member tells, knowing of its step, that is otherwise than the step was to
   *     make it
   */
  record Change(
      long version,
      Source source,
      List<String> facts,
      List<String> expected,
      List<String> denials) {

    public Change(long version, Source source, List<String> facts, List<String> expected) {
      this(version, source, facts, expected, List.of());
    }

    public Change(long version, Source source, List<String> facts) {
      this(version, source, facts, List.of());
    }

    /** What somebody has reported. */
    public List<String> reported() {
      return facts.stream().filter(fact -> !expected.contains(fact)).toList();
    }

    /** The same, where this was reported, be it that it was known already. */
    public Change with(List<String> words) {
      return new Change(
          version,
          source,
          Stream.concat(words.stream(), facts.stream()).distinct().toList(),
          expected.stream().filter(fact -> !words.contains(fact)).toList(),
          denials);
    }

    /** The same, where the member tells this against its step's being done. */
    public Change denying(List<String> words) {
      return new Change(version, source, facts, expected, words);
    }
  }
}
