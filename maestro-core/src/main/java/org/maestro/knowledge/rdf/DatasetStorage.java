package org.maestro.knowledge.rdf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.apache.jena.dboe.base.block.FileMode;
import org.apache.jena.dboe.base.file.Location;
import org.apache.jena.dboe.sys.SystemIndex;
import org.apache.jena.graph.Node;
import org.apache.jena.query.ARQ;
import org.apache.jena.query.DatasetFactory;
import org.apache.jena.query.QueryCancelledException;
import org.apache.jena.query.QueryDeniedException;
import org.apache.jena.query.QueryExecution;
import org.apache.jena.query.QueryParseException;
import org.apache.jena.query.TxnType;
import org.apache.jena.shared.JenaException;
import org.apache.jena.sparql.core.DatasetGraph;
import org.apache.jena.sparql.core.DatasetGraphFactory;
import org.apache.jena.sparql.core.Quad;
import org.apache.jena.sys.JenaSystem;
import org.apache.jena.system.Txn;
import org.apache.jena.tdb2.DatabaseMgr;
import org.apache.jena.tdb2.params.StoreParams;
import org.apache.jena.tdb2.sys.TDBInternal;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.storage.StorageFault;

/**
 * Jena's transactional dataset in this process, in memory or on disk (TDB2), by its graph
 * interface: SPARQL Update text costs five times as much.
 */
public final class DatasetStorage implements GraphStorage {
  private static final String JENA = "org.apache.jena.";

  /** TDB2 only ever appends; beyond this it is written anew when it is opened. */
  private static final long COMPACTED_FROM_BYTES = 256L << 20;

  /*
   * Files are not mapped into memory: who touches a page for which a full disk has no room gets an
   * error of the virtual machine, and none that could be lived with. It can be said once only. What
   * this asks for after a kill is done by StoreFiles.
   */
  static {
    JenaSystem.init();
    SystemIndex.setFileMode(FileMode.direct);
  }

  /**
   * More than a transaction takes. With less on its disk nothing is begun: Jena's cache of blocks
   * swallows the failure of a write that it has put off, and may end well without it.
   */
  private static final long LEAST_ROOM_BYTES = 32L << 20;

  private final DatasetGraph dataset;
  private final Optional<Path> directory;

  private DatasetStorage(DatasetGraph dataset, Optional<Path> directory) {
    this.dataset = dataset;
    this.directory = directory;
  }

  static DatasetStorage inMemory() {
    JenaSystem.init();
    return new DatasetStorage(DatasetGraphFactory.createTxnMem(), Optional.empty());
  }

  /**
   * @throws KnowledgeException when the directory cannot be used, or another process has it
   */
  public static DatasetStorage onDisk(Path directory) {
    JenaSystem.init();
    try {
      Files.createDirectories(directory);
      StoreFiles files = new StoreFiles(directory);
      files.settle();
      Optional<String> missing = files.missing();
      if (missing.isPresent()) {
        throw new KnowledgeException(damaged(directory, missing.get()));
      }
      DatasetGraph dataset =
          DatabaseMgr.connectDatasetGraph(
              Location.create(directory), StoreParams.getSmallStoreParams());
      if (size(directory) > COMPACTED_FROM_BYTES) {
        DatabaseMgr.compact(dataset, true);
      }
      return new DatasetStorage(dataset, Optional.of(directory));
    } catch (IOException | JenaException e) {
      throw new KnowledgeException(
          "The store in %s cannot be used (%s); name a directory that can be written, and that no other process has, or when it is damaged, put a copy in its place, or move it away to begin without what was known."
              .formatted(directory, words(e)),
          e);
    } catch (KnowledgeException known) {
      throw known;
    } catch (RuntimeException damaged) {
      throw damaged(directory, damaged);
    }
  }

  private static KnowledgeException damaged(Path directory, RuntimeException because) {
    return new KnowledgeException(damaged(directory, words(because)), because);
  }

  private static String damaged(Path directory, String because) {
    return "The store in %s cannot be read (%s); put a copy in its place, or move it away to begin without what was known."
        .formatted(directory, because);
  }

  /** Jena tells by what it was hindered in the cause, or not at all. */
  private static String words(Throwable failure) {
    for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
      if (cause instanceof IOException known) {
        return StorageFault.words(known);
      }
    }
    return Optional.ofNullable(failure.getMessage())
        .filter(text -> failure.getClass().getName().startsWith(JENA))
        .flatMap(text -> text.lines().findFirst())
        .orElse("what stands in its files does not fit together");
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
    directory.ifPresent(DatasetStorage::requireRoom);
    dataset.begin(TxnType.WRITE);
    try {
      edits.forEach(this::apply);
      dataset.commit();
    } catch (RuntimeException failure) {
      abort(failure);
      throw directory
          .<RuntimeException>map(
              place -> new KnowledgeException(notTaken(place, words(failure)), failure))
          .orElse(failure);
    } finally {
      dataset.end();
    }
  }

  private static void requireRoom(Path directory) {
    try {
      long room = Files.getFileStore(directory).getUsableSpace();
      if (room < LEAST_ROOM_BYTES) {
        throw new KnowledgeException(
            notTaken(
                directory,
                "of the %d MiB that it needs to write, %d are free on its disk"
                    .formatted(LEAST_ROOM_BYTES >> 20, room >> 20)));
      }
    } catch (IOException e) {
      throw new KnowledgeException(notTaken(directory, words(e)), e);
    }
  }

  private static String notTaken(Path directory, String because) {
    return "The store in %s does not take what is to be kept: %s.".formatted(directory, because);
  }

  /** What is not written yet may fail here once more. */
  private void abort(RuntimeException because) {
    try {
      dataset.abort();
    } catch (RuntimeException again) {
      because.addSuppressed(again);
    }
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
  public List<Map<String, String>> select(String query, Duration within) {
    try {
      return Txn.calculateRead(
          dataset,
          () -> {
            try (QueryExecution execution =
                QueryExecution.dataset(DatasetFactory.wrap(dataset))
                    .query(query)
                    .set(ARQ.httpServiceAllowed, false)
                    .timeout(within.toMillis(), TimeUnit.MILLISECONDS)
                    .build()) {
              return Rows.of(execution.execSelect());
            }
          });
    } catch (QueryParseException e) {
      throw Rows.noQuery(e);
    } catch (QueryDeniedException e) {
      throw new KnowledgeException(
          "SERVICE would have the platform ask another one; leave it away.", e);
    } catch (QueryCancelledException e) {
      throw new KnowledgeException(
          "The query takes longer than %d s; ask for less.".formatted(within.toSeconds()), e);
    } catch (RuntimeException e) {
      throw directory.<RuntimeException>map(place -> damaged(place, e)).orElse(e);
    }
  }

  @Override
  public boolean isLasting() {
    return directory.isPresent();
  }

  @Override
  public void close() {
    if (directory.isPresent()) {
      TDBInternal.expel(dataset);
    } else {
      dataset.close();
    }
  }
}
