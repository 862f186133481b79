package org.maestro.knowledge.rdf;

import java.time.Duration;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.api.Store;

/** Opens the storage that the settings name. */
public final class GraphStorageFactory {
  /** How long who reads waits for a slow storage. */
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  private GraphStorageFactory() {}

  /**
   * What is slow is written beside those who write.
   *
   * @throws KnowledgeException when it cannot be used
   */
  public static GraphStorage open(Store store) {
    if (store instanceof Store.OnDisk disk) {
      return new WriteBehind(DatasetStorage.onDisk(disk.directory()), PATIENCE).begin();
    } else if (store instanceof Store.Endpoint endpoint) {
      return new WriteBehind(EndpointStorage.open(endpoint.queries(), endpoint.updates()), PATIENCE)
          .begin();
    }
    return DatasetStorage.inMemory();
  }
}
