package org.maestro.knowledge.rdf;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.apache.jena.query.Query;
import org.apache.jena.query.QueryException;
import org.apache.jena.query.QueryFactory;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.api.QueryAnswer;

/**
 * A SPARQL query of somebody else: it reads, asks nobody else, and ends after a while and after so
 * many rows.
 */
public final class ForeignQuery {
  /** Wall time. */
  private static final Duration WITHIN = Duration.ofSeconds(10);

  private static final int MOST_ROWS = 1_000;

  private final Query query;

  private ForeignQuery(Query query) {
    this.query = query;
  }

  /**
   * @throws KnowledgeException when it is no SPARQL, no SELECT, or would call Java
   */
  public static ForeignQuery of(String text) {
    Query query;
    try {
      query = QueryFactory.create(text);
    } catch (QueryException e) {
      throw Rows.noQuery(e);
    }
    if (!query.isSelectType()) {
      throw new KnowledgeException(
          "Only SELECT is answered; write SELECT with the variables that you ask for.");
    }
    if (query.toString().toLowerCase(Locale.ROOT).contains("<java:")) {
      throw new KnowledgeException("Functions of Java are not called; leave them away.");
    }
    if (!query.hasLimit() || query.getLimit() > MOST_ROWS) {
      query.setLimit(MOST_ROWS + 1L);
    }
    return new ForeignQuery(query);
  }

  /** Asks it. */
  public QueryAnswer ask(GraphStorage storage) {
    List<Map<String, String>> rows = storage.select(query.toString(), WITHIN);
    return new QueryAnswer(
        query.getResultVars(),
        rows.subList(0, Math.min(rows.size(), MOST_ROWS)),
        rows.size() <= MOST_ROWS);
  }
}
