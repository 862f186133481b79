package org.maestro.knowledge.rdf;

import java.net.ConnectException;
import java.net.URI;
import java.net.http.HttpClient;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.apache.jena.atlas.web.HttpException;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.NodeFactory;
import org.apache.jena.query.Query;
import org.apache.jena.query.QueryFactory;
import org.apache.jena.query.QueryParseException;
import org.apache.jena.query.ResultSet;
import org.apache.jena.sparql.core.Quad;
import org.apache.jena.sparql.core.Var;
import org.apache.jena.sparql.engine.http.QueryExceptionHTTP;
import org.apache.jena.sparql.exec.QueryExec;
import org.apache.jena.sparql.exec.http.QueryExecHTTP;
import org.apache.jena.sparql.exec.http.UpdateExecHTTP;
import org.apache.jena.sparql.modify.request.QuadAcc;
import org.apache.jena.sparql.modify.request.QuadDataAcc;
import org.apache.jena.sparql.modify.request.UpdateClear;
import org.apache.jena.sparql.modify.request.UpdateDataDelete;
import org.apache.jena.sparql.modify.request.UpdateDataInsert;
import org.apache.jena.sparql.modify.request.UpdateDeleteWhere;
import org.apache.jena.sys.JenaSystem;
import org.apache.jena.update.UpdateRequest;
import org.maestro.knowledge.api.KnowledgeException;

/**
 * A dataset behind a SPARQL 1.1 endpoint, by Query and Update over HTTP. The edits of one call go
 * in one request.
 */
final class EndpointStorage implements GraphStorage {
  private static final Duration CONNECTED_WITHIN = Duration.ofSeconds(5);
  private static final Duration ANSWERED_WITHIN = Duration.ofSeconds(20);
  private static final String ALWAYS_TRUE = "ASK {}";

  private final URI queries;
  private final URI updates;
  private final HttpClient client =
      HttpClient.newBuilder()
          .connectTimeout(CONNECTED_WITHIN)
          .followRedirects(HttpClient.Redirect.NORMAL)
          .build();

  private EndpointStorage(URI queries, URI updates) {
    this.queries = queries;
    this.updates = updates;
  }

  /**
   * @throws KnowledgeException when nobody answers SPARQL queries there
   */
  static EndpointStorage open(URI queries, URI updates) {
    JenaSystem.init();
    EndpointStorage storage = new EndpointStorage(queries, updates);
    try (QueryExec probe = storage.execution(QueryFactory.create(ALWAYS_TRUE), ANSWERED_WITHIN)) {
      probe.ask();
      return storage;
    } catch (HttpException | QueryExceptionHTTP e) {
      throw new KnowledgeException(
          "No SPARQL endpoint answers at %s (%s); start one there, or name another with --store."
              .formatted(queries, reason(e)),
          e);
    }
  }

  private static String reason(RuntimeException e) {
    Throwable cause = e;
    while (cause.getCause() != null && !(cause instanceof ConnectException)) {
      cause = cause.getCause();
    }
    if (cause instanceof ConnectException) {
      return "nothing listens there";
    }
    return cause.getMessage() == null
        ? cause.getClass().getSimpleName()
        : cause.getMessage().lines().findFirst().orElse("");
  }

  @Override
  public void apply(List<Edit> edits) {
    UpdateRequest request = new UpdateRequest();
    edits.forEach(edit -> add(edit, request));
    if (request.getOperations().isEmpty()) {
      return;
    }
    try {
      UpdateExecHTTP.service(updates.toString())
          .httpClient(client)
          .update(request)
          .timeout(ANSWERED_WITHIN.toSeconds(), TimeUnit.SECONDS)
          .build()
          .execute();
    } catch (HttpException e) {
      throw new KnowledgeException(
          "The SPARQL endpoint %s does not take what is to be kept (%s); see its log."
              .formatted(updates, reason(e)),
          e);
    }
  }

  private static void add(Edit edit, UpdateRequest request) {
    if (edit instanceof Edit.Replacement replacement) {
      Node graph = safe(replacement.graph());
      request.add(new UpdateClear(graph, true));
      insert(
          replacement.triples().stream().map(triple -> Quad.create(graph, triple)).toList(),
          request);
    } else if (edit instanceof Edit.Change change) {
      if (!change.removed().isEmpty()) {
        request.add(new UpdateDataDelete(new QuadDataAcc(safe(change.removed()))));
      }
      change
          .forgotten()
          .forEach(
              gone ->
                  request.add(
                      new UpdateDeleteWhere(
                          new QuadAcc(
                              new ArrayList<>(
                                  List.of(
                                      Quad.create(
                                          safe(gone.graph()),
                                          safe(gone.subject()),
                                          Var.alloc("p"),
                                          Var.alloc("o"))))))));
      insert(change.added(), request);
    }
  }

  private static void insert(List<Quad> quads, UpdateRequest request) {
    if (!quads.isEmpty()) {
      request.add(new UpdateDataInsert(new QuadDataAcc(safe(quads))));
    }
  }

  private static List<Quad> safe(List<Quad> quads) {
    List<Quad> safe = new ArrayList<>();
    quads.forEach(
        quad ->
            safe.add(
                Quad.create(
                    safe(quad.getGraph()),
                    safe(quad.getSubject()),
                    safe(quad.getPredicate()),
                    safe(quad.getObject()))));
    return safe;
  }

  /**
   * Names come from anybody: what may not stand in an IRI would end it, and begin another update.
   */
  private static Node safe(Node node) {
    if (!node.isURI() || node.getURI().chars().noneMatch(EndpointStorage::isForbidden)) {
      return node;
    }
    StringBuilder iri = new StringBuilder();
    node.getURI()
        .codePoints()
        .forEach(
            point -> {
              if (isForbidden(point)) {
                for (byte part : Character.toString(point).getBytes(StandardCharsets.UTF_8)) {
                  iri.append("%%%02X".formatted(part));
                }
              } else {
                iri.appendCodePoint(point);
              }
            });
    return NodeFactory.createURI(iri.toString());
  }

  private static boolean isForbidden(int point) {
    return point <= ' ' || "<>\"{}|^`\\".indexOf(point) >= 0;
  }

  @Override
  public List<Map<String, String>> select(String query, Duration within) {
    try (QueryExec execution = execution(QueryFactory.create(query), within)) {
      return Rows.of(ResultSet.adapt(execution.select()));
    } catch (QueryParseException e) {
      throw Rows.noQuery(e);
    } catch (HttpException | QueryExceptionHTTP e) {
      throw new KnowledgeException(
          "The SPARQL endpoint %s does not answer (%s); see to it, or ask again later."
              .formatted(queries, reason(e)),
          e);
    }
  }

  private QueryExec execution(Query query, Duration within) {
    return QueryExecHTTP.service(queries.toString())
        .httpClient(client)
        .query(query)
        .timeout(Math.min(within.toMillis(), ANSWERED_WITHIN.toMillis()), TimeUnit.MILLISECONDS)
        .build();
  }

  @Override
  public boolean isLasting() {
    return true;
  }

  @Override
  public void close() {
    // The endpoint stays, and HTTP keeps nothing open.
  }
}
