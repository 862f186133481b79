package org.maestro.knowledge;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.apache.jena.dboe.base.file.Location;
import org.apache.jena.graph.Node;
import org.apache.jena.query.DatasetFactory;
import org.apache.jena.query.QueryExecution;
import org.apache.jena.query.QueryParseException;
import org.apache.jena.shared.JenaException;
import org.apache.jena.sparql.core.DatasetGraph;
import org.apache.jena.sparql.core.DatasetGraphFactory;
import org.apache.jena.sparql.core.Quad;
import org.apache.jena.sys.JenaSystem;
import org.apache.jena.system.Txn;
import org.apache.jena.tdb2.DatabaseMgr;
import org.apache.jena.tdb2.params.StoreParams;
import org.apache.jena.tdb2.sys.TDBInternal;

/**
 * Jena's transactional dataset in this process, in memory or on disk (TDB2), by its graph
 * interface: SPARQL Update text costs five times as much.
 */
final class DatasetStorage implements GraphStorage {
  /** TDB2 only ever appends; beyond this it is written anew when it is opened. */
  private static final long COMPACTED_FROM_BYTES = 256L << 20;

  private final DatasetGraph dataset;
  private final boolean lasting;

  private DatasetStorage(DatasetGraph dataset, boolean lasting) {
    this.dataset = dataset;
    this.lasting = lasting;
  }

  static DatasetStorage inMemory() {
    JenaSystem.init();
    return new DatasetStorage(DatasetGraphFactory.createTxnMem(), false);
  }

  /**
   * @throws KnowledgeException when the directory cannot be used, or another process has it
   */
  static DatasetStorage onDisk(Path directory) {
    JenaSystem.init();
    try {
      Files.createDirectories(directory);
      DatasetGraph dataset =
          DatabaseMgr.connectDatasetGraph(
              Location.create(directory), StoreParams.getSmallStoreParams());
      if (size(directory) > COMPACTED_FROM_BYTES) {
        DatabaseMgr.compact(dataset, true);
      }
      return new DatasetStorage(dataset, true);
    } catch (IOException | JenaException e) {
      throw new KnowledgeException(
          "The store in %s cannot be used (%s); name a directory that can be written, and that no other process has."
              .formatted(directory, e.getMessage()),
          e);
    }
  }

  private static long size(Path directory) throws IOException {
    try (Stream<Path> files = Files.walk(directory)) {
      long bytes = 0;
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        bytes += Files.size(file);
      }
      return bytes;
    }
  }

  @Override
  public void apply(List<Edit> edits) {
    Txn.executeWrite(dataset, () -> edits.forEach(this::apply));
  }

  private void apply(Edit edit) {
    if (edit instanceof Edit.Replacement replacement) {
      Node graph = replacement.graph();
      dataset.deleteAny(graph, Node.ANY, Node.ANY, Node.ANY);
      replacement.triples().forEach(triple -> dataset.add(Quad.create(graph, triple)));
    } else if (edit instanceof Edit.Change change) {
      change.removed().forEach(dataset::delete);
      change
          .forgotten()
          .forEach(gone -> dataset.deleteAny(gone.graph(), gone.subject(), Node.ANY, Node.ANY));
      change.added().forEach(dataset::add);
    }
  }

  @Override
  public List<Map<String, String>> select(String query) {
    try {
      return Txn.calculateRead(
          dataset,
          () -> {
            try (QueryExecution execution =
                QueryExecution.dataset(DatasetFactory.wrap(dataset)).query(query).build()) {
              return Rows.of(execution.execSelect());
            }
          });
    } catch (QueryParseException e) {
      throw Rows.noQuery(e);
    }
  }

  @Override
  public boolean isLasting() {
    return lasting;
  }

  @Override
  public void close() {
    if (lasting) {
      TDBInternal.expel(dataset);
    } else {
      dataset.close();
    }
  }
}
