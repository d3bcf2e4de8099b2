import react from '@vitejs/plugin-react';
import { createServer, type ViteDevServer } from 'vite';
import { installPackedLibrary, projectFolder } from './packedLibrary.js';

/** A development server with hot reload, for a page that uses the packed library with React. */
export interface ReactServer {
  readonly address: string;
  close(): Promise<void>;
}

/**
 * Starts the server.
 *
 * @param page the page that is opened first, such as `react.html`
 * @param packages what the page imports beside the library, React and React Three Fiber
 */
export async function startReactServer(page: string, packages: readonly string[] = []): Promise<ReactServer> {
  installPackedLibrary();
  const environment = process.env.NODE_ENV;
  // A build by Vite, as in earlier tests, leaves "production" here, which disables hot reload.
  process.env.NODE_ENV = 'development';
  const server: ViteDevServer = await createServer({
    configFile: false,
    root: projectFolder,
    logLevel: 'error',
    cacheDir: `${projectFolder}/.vite-${page}`,
    plugins: [react()],
    server: { host: '127.0.0.1', port: 0 },
    optimizeDeps: {
      entries: [page],
      include: [
        ...['three', 'three-hatching', 'three-hatching/react', '@react-three/fiber'],
        ...['react', 'react-dom/client', 'react/jsx-runtime', 'react/jsx-dev-runtime'],
        ...packages,
      ],
    },
  });
  await server.listen();
  return {
    address: server.resolvedUrls!.local[0],
    close: async () => {
      if (environment === undefined) delete process.env.NODE_ENV;
      else process.env.NODE_ENV = environment;
      await server.close();
    },
  };
}
