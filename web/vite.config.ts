import { defineConfig } from 'vitest/config';

// Names without hashes: the committed bundle's files keep theirs from one build to the next.
export default defineConfig({
  build: {
    target: 'es2022',
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 700,
    rollupOptions: {
      input: { studio: 'index.html', report: 'src/report.ts' },
      output: {
        entryFileNames: 'assets/[name].js',
        chunkFileNames: 'assets/[name].js',
        assetFileNames: 'assets/[name][extname]',
      },
    },
  },
  worker: { rollupOptions: { output: { entryFileNames: 'assets/[name].js' } } },
  test: { include: ['tests/*.test.ts'] },
});
